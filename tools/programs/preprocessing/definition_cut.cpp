#include "preprocessing/definition_cut.h"

#include <algorithm>

namespace penumbra::preprocessing {

namespace {

class DefinitionCut {
 public:
  explicit DefinitionCut(const std::vector<Token>& line) : line_(line) {}

  std::optional<Definition> run() {
    if (line_.empty() || line_.front().kind != Kind::identifier ||
        line_.front().spelling == known::word_defined)
      return std::nullopt;
    out_.name = line_.front().spelling;
    at_ = 1;
    if (at_ < line_.size() && !line_[at_].space) {
      if (!line_[at_].is(known::open) || !list()) return std::nullopt;
    }
    body();
    return std::move(out_);
  }

 private:
  bool list() {
    out_.has_list = true;
    ++at_;
    if (at_ < line_.size() && line_[at_].is(known::close)) {
      ++at_;
      return true;
    }
    for (; at_ + 1 < line_.size(); at_ += 2) {
      const Token& name = line_[at_];
      const bool again = std::count(out_.parameters.begin(), out_.parameters.end(), name.spelling) != 0;
      if (name.kind != Kind::identifier || again) return false;
      out_.parameters.push_back(name.spelling);
      if (line_[at_ + 1].is(known::comma)) continue;
      const bool closed = line_[at_ + 1].is(known::close);
      at_ += 2;
      return closed;
    }
    return false;
  }

  void body() {
    for (; at_ < line_.size(); ++at_) {
      Token token = line_[at_];
      const bool doubled = token.is(known::hash) && at_ + 1 < line_.size() &&
                           line_[at_ + 1].is(known::hash) && !line_[at_ + 1].space;
      if (doubled) {
        token.kind = Kind::paste;
        ++at_;
      }
      token.parameter = parameter(token);
      out_.body.push_back(token);
    }
  }

  std::int16_t parameter(const Token& token) const {
    const auto place = std::find(out_.parameters.begin(), out_.parameters.end(), token.spelling);
    if (token.kind != Kind::identifier || place == out_.parameters.end()) return no_parameter;
    return static_cast<std::int16_t>(place - out_.parameters.begin());
  }

  const std::vector<Token>& line_;
  Definition out_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Definition> cut_definition(const std::vector<Token>& line) {
  return DefinitionCut(line).run();
}

bool are_identical(const Definition& a, const Definition& b) {
  if (a.has_list != b.has_list || a.parameters != b.parameters || a.body.size() != b.body.size())
    return false;
  for (std::size_t i = 0; i < a.body.size(); ++i) {
    const Token& one = a.body[i];
    const Token& other = b.body[i];
    if (one.kind != other.kind || one.spelling != other.spelling) return false;
    if (i > 0 && one.space != other.space) return false;
  }
  return true;
}

}  // namespace penumbra::preprocessing
