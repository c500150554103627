#include "input/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace penumbra {
namespace {

constexpr std::size_t kLongestName = 200;  // a longer one is not a typing error
constexpr std::size_t kMostListed = 60;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Returns the optimal string alignment distance: insertions, deletions, substitutions and swaps of neighbours
// cost one.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> current(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, substitution});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) current[j] = std::min(current[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, current);
  }
  return last[b.size()];
}

bool word_starts_at(const std::string& name, std::size_t at) {
  return at == 0 || std::isalnum(static_cast<unsigned char>(name[at - 1])) == 0;
}

// Returns the place in the name at which a word begins with the given text; npos if none does.
std::size_t word_beginning_with(const std::string& name, const std::string& given) {
  std::size_t at = name.find(given);
  while (at != std::string::npos && !word_starts_at(name, at)) at = name.find(given, at + 1);
  return at;
}

// Returns the known name that contains the given one.
std::string longer_name(const std::string& given, const std::vector<std::string>& known) {
  if (given.size() < 3) return {};
  std::string first_word;
  std::string any_word;
  const auto keep_shorter = [](std::string& best, const std::string& name) {
    if (best.empty() || name.size() < best.size()) best = name;
  };
  for (const std::string& name : known) {
    const std::size_t at = word_beginning_with(lower(name), given);
    if (at == 0) keep_shorter(first_word, name);
    if (at != std::string::npos) keep_shorter(any_word, name);
  }
  return first_word.empty() ? any_word : first_word;
}

}  // namespace

std::string nearest_name(std::string_view given, const std::vector<std::string>& known) {
  if (given.size() > kLongestName) return {};
  const std::string wanted = lower(given);
  std::size_t best = std::max<std::size_t>(2, given.size() / 3) + 1;
  std::string nearest;
  for (const std::string& name : known) {
    if (name.size() >= wanted.size() + best || wanted.size() >= name.size() + best) continue;
    const std::size_t distance = edit_distance(wanted, lower(name));
    if (distance < best) {
      best = distance;
      nearest = name;
    }
  }
  if (best <= 1) return nearest;
  const std::string longer = longer_name(wanted, known);
  return longer.empty() ? nearest : longer;
}

std::string unknown_name_remedy(std::string_view given, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(given, known);
  if (!nearest.empty()) return "did you mean '" + nearest + "'?";
  std::string list = "known are:";
  for (std::size_t i = 0; i < std::min(known.size(), kMostListed); ++i) list += " " + known[i];
  if (known.size() > kMostListed) list += " and " + std::to_string(known.size() - kMostListed) + " more";
  return list;
}

}  // namespace penumbra
