#include "study/kept_records.h"

#include <array>
#include <stdexcept>
#include <utility>

#include "platform/byte_stream.h"

namespace penumbra::study {
namespace {

constexpr std::array kPictures{&PictureRow::reference, &PictureRow::result,       &PictureRow::error,
                               &PictureRow::fetches,   &PictureRow::fetch_counts, &PictureRow::mask};

void write_picture(platform::ByteWriter& out, const PackedPicture& picture) {
  out.values(picture.png());
}

PackedPicture read_picture(platform::ByteReader& in) {
  return PackedPicture(in.values<std::byte>());
}

std::string encode(const KeptRecord& kept) {
  Results results;
  results.is_software = true;  // any value serves, as writing and reading agree
  results.frames = {kept.frame};
  results.records = {kept.record};
  platform::ByteWriter out;
  out.text(to_json(results));
  for (const auto picture : kPictures) write_picture(out, kept.pictures.*picture);
  out.list(kept.pictures.debug_views, [&](const auto& view) {
    out.text(view.first);
    write_picture(out, view.second);
  });
  out.value(kept.pictures.error_scale);
  out.value(kept.pictures.fetch_scale);
  out.list(kept.unset_uniforms, [&](const std::string& name) { out.text(name); });
  return out.take();
}

KeptRecord decode(const std::string& bytes) {
  platform::ByteReader in(bytes);
  Results results = parse_results(in.text(), "a kept record");
  KeptRecord kept{std::move(results.frames.at(0)), std::move(results.records.at(0)), {}, {}};
  kept.pictures.scene = kept.record.scene;
  kept.pictures.technique = kept.record.technique;
  kept.pictures.light_degrees = kept.record.light_degrees;
  for (const auto picture : kPictures) kept.pictures.*picture = read_picture(in);
  using View = std::pair<std::string, PackedPicture>;
  for (View& view : in.list<View>([&] {
         std::string name = in.text();
         return View{std::move(name), read_picture(in)};
       }))
    kept.pictures.debug_views.insert(std::move(view));
  kept.pictures.error_scale = in.value<double>();
  kept.pictures.fetch_scale = in.value<double>();
  kept.unset_uniforms = in.list<std::string>([&] { return in.text(); });
  if (!in.exhausted()) throw std::invalid_argument("a kept record is damaged");
  return kept;
}

}  // namespace

KeptRecords::KeptRecords(const std::filesystem::path& folder)
    : store_(folder.empty() ? platform::cache_directory("reference") : folder) {}

std::optional<KeptRecord> KeptRecords::find(const std::string& key) {
  const std::optional<std::string> entry = store_.find(kept_record_kind, key);
  if (!entry) return std::nullopt;
  try {
    KeptRecord kept = decode(*entry);
    keys_.insert(key);
    return kept;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

void KeptRecords::store(const std::string& key, const KeptRecord& kept) {
  if (store_.store(kept_record_kind, key, encode(kept)))
    keys_.insert(key);
  else
    complete_ = false;
}

void KeptRecords::drop() {
  for (const std::string& key : keys_) store_.drop(kept_record_kind, key);
  keys_.clear();
}

}  // namespace penumbra::study
