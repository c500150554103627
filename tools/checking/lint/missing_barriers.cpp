#include <algorithm>
#include <map>
#include <string>

#include "lint/divergence.h"
#include "lint/stage_rules.h"
#include "lint/thread_values.h"

namespace penumbra::lint {
namespace {

using OfThreads = ThreadValues::OfThreads;

bool is_wave_operation(const spirv::Instruction& instruction) {
  return instruction.op >= spv::OpGroupNonUniformElect && instruction.op <= spv::OpGroupNonUniformQuadSwap;
}

// A read or write of group shared memory: of the variable, or the part of it that the indices choose.
struct Access {
  const spirv::Instruction* instruction = nullptr;
  std::size_t node = 0;
  spirv::Id variable = 0;
  std::vector<spirv::Id> indices;
};

// Two threads: one writes what the other reads.
struct Conflict {
  std::size_t writer = 0;
  std::size_t reader = 0;
};

class SharedMemory {
 public:
  SharedMemory(const LintedCode& linted, const spirv::Function& function)
      : linted_(linted),
        function_(function),
        divergence_(linted.code, function, Together::group),
        values_(linted.code) {
    for (const std::size_t node : flow().order) add_accesses(node);
    for (const std::size_t header : flow().order) {
      std::vector<bool> body = loop_body(flow(), header);
      if (body.empty()) continue;
      if (std::any_of(flow().order.begin(), flow().order.end(),
                      [&](std::size_t node) { return body[node] && has_barrier(node); }))
        loops_.push_back(std::move(body));
    }
  }

  std::vector<hlsl::Diagnostic> findings() {
    std::vector<hlsl::Diagnostic> findings;
    if (values_.threads() < 2) return findings;
    std::vector<const spirv::Instruction*> told;
    for (const Access& write : writes_)
      for (const Access& read : reads_without_barrier(write)) {
        if (std::find(told.begin(), told.end(), read.instruction) != told.end()) continue;
        const std::optional<Conflict> threads = conflict(write, read);
        if (!threads) continue;
        told.push_back(read.instruction);
        findings.push_back(finding_of(write, read, *threads));
      }
    return findings;
  }

 private:
  const ControlFlow& flow() const { return divergence_.flow(); }

  bool has_barrier(std::size_t node) const {
    const auto all = linted_.code.instructions().begin();
    const spirv::Block& block = function_.blocks[node];
    return std::any_of(all + static_cast<std::ptrdiff_t>(block.begin),
                       all + static_cast<std::ptrdiff_t>(block.end), is_barrier);
  }

  void add_accesses(std::size_t node) {
    for (std::size_t i = function_.blocks[node].begin; i < function_.blocks[node].end; ++i) {
      const spirv::Instruction& instruction = linted_.code.instructions()[i];
      if (instruction.op != spv::OpStore && instruction.op != spv::OpLoad) continue;
      Access access{&instruction, node, instruction.operands[0], {}};
      const spirv::Instruction* at = linted_.code.definition(access.variable);
      for (; at->op == spv::OpAccessChain; at = linted_.code.definition(access.variable)) {
        access.indices.insert(access.indices.begin(), at->operands.begin() + 1, at->operands.end());
        access.variable = at->operands[0];
      }
      if (at->op == spv::OpVariable && at->operands[0] == spv::StorageClassWorkgroup)
        (instruction.op == spv::OpStore ? writes_ : reads_).push_back(std::move(access));
    }
  }

  // Loops with a barrier count as executed at least once.
  bool leaves_unexecuted_loop(std::size_t from, std::size_t to, std::size_t write) const {
    return std::any_of(loops_.begin(), loops_.end(), [&](const std::vector<bool>& body) {
      return body[from] && !body[to] && !body[write];
    });
  }

  // Returns the reads of the variable that a thread may reach from the write without a barrier.
  std::vector<Access> reads_without_barrier(const Access& write) const {
    std::vector<Access> found;
    std::vector<bool> seen(function_.blocks.size());
    std::vector<std::size_t> waiting{write.node};
    for (bool first = true; !waiting.empty(); first = false) {
      const std::size_t node = waiting.back();
      waiting.pop_back();
      const spirv::Instruction* begin = &linted_.code.instructions()[function_.blocks[node].begin];
      const spirv::Instruction* end = begin + (function_.blocks[node].end - function_.blocks[node].begin);
      if (first) begin = write.instruction;
      const spirv::Instruction* barrier = std::find_if(begin, end, is_barrier);
      for (const Access& read : reads_)
        if (read.variable == write.variable && read.instruction >= begin && read.instruction < barrier)
          found.push_back(read);
      if (barrier != end) continue;
      for (const std::size_t to : flow().successors[node]) {
        if (seen[to] || leaves_unexecuted_loop(node, to, write.node)) continue;
        seen[to] = true;
        waiting.push_back(to);
      }
    }
    return found;
  }

  // Returns the threads that execute the block, as far as their numbers alone decide; all, where other values
  // do.
  OfThreads executing(std::size_t node) {
    OfThreads threads(values_.threads(), 1);
    for (std::size_t at = node; flow().dominator[at] != at; at = flow().dominator[at]) {
      const std::size_t above = flow().dominator[at];
      const spirv::Instruction& branch = terminator(linted_.code, function_.blocks[above]);
      if (branch.op != spv::OpBranchConditional || flow().predecessors[at].size() != 1) continue;
      const OfThreads* condition = values_.of(branch.operands[0]);
      if (condition == nullptr) continue;
      const std::uint32_t wanted = branch.operands[1] == function_.blocks[at].label ? 1 : 0;
      for (std::size_t i = 0; i < threads.size(); ++i)
        if ((*condition)[i] != wanted) threads[i] = 0;
    }
    return threads;
  }

  // An index is known for every thread, or it is the same for the whole group; otherwise nothing is said. An
  // index of the second kind is taken for that of any element, if the threads write different ones.
  std::optional<Conflict> conflict(const Access& write, const Access& read) {
    std::vector<std::pair<const OfThreads*, const OfThreads*>> compared;
    for (std::size_t i = 0; i < std::min(write.indices.size(), read.indices.size()); ++i) {
      if (write.indices[i] == read.indices[i] && !divergence_.varies(write.indices[i])) continue;
      const OfThreads* written = values_.of(write.indices[i]);
      const OfThreads* wanted = values_.of(read.indices[i]);
      if (written == nullptr || (wanted == nullptr && divergence_.varies(read.indices[i])))
        return std::nullopt;
      if (wanted == nullptr && std::equal(written->begin() + 1, written->end(), written->begin()))
        return std::nullopt;
      compared.emplace_back(written, wanted);
    }
    const OfThreads writers = executing(write.node);
    const OfThreads readers = executing(read.node);
    // Returns the indices that the thread writes; of those alone that are compared with known ones, if asked.
    const auto written_by = [&](std::size_t thread, bool known) {
      OfThreads element;
      for (const auto& [written, wanted] : compared)
        if (!known || wanted != nullptr) element.push_back((*written)[thread]);
      return element;
    };
    // The first writers of two elements, by the indices that a reader knows: a thread may write one of the
    // two itself.
    std::map<OfThreads, std::vector<std::size_t>> first_writers;
    for (std::size_t writer = 0; writer < writers.size(); ++writer) {
      if (writers[writer] == 0) continue;
      std::vector<std::size_t>& first = first_writers[written_by(writer, true)];
      if (first.empty() || (first.size() == 1 && written_by(first[0], false) != written_by(writer, false)))
        first.push_back(writer);
    }
    for (std::size_t reader = 0; reader < readers.size(); ++reader) {
      if (readers[reader] == 0) continue;
      OfThreads element;
      for (const auto& [written, wanted] : compared)
        if (wanted != nullptr) element.push_back((*wanted)[reader]);
      const auto first = first_writers.find(element);
      if (first == first_writers.end()) continue;
      for (const std::size_t writer : first->second)
        if (writers[reader] == 0 || written_by(reader, false) != written_by(writer, false))
          return Conflict{writer, reader};
    }
    return std::nullopt;
  }

  hlsl::Diagnostic finding_of(const Access& write, const Access& read, const Conflict& threads) const {
    const std::string name = linted_.code.name(read.variable);
    const spirv::Place place = read.instruction->place;
    return finding_at(linted_, "missing-barrier", place, {name},
                      "thread " + std::to_string(threads.reader) + " of a group reads from '" + name +
                          "' what thread " + std::to_string(threads.writer) + " writes" +
                          place_in_words(linted_, write.instruction->place, place) +
                          ", and may read before it is written: put GroupMemoryBarrierWithGroupSync() "
                          "between them");
  }

  const LintedCode& linted_;
  const spirv::Function& function_;
  const Divergence divergence_;
  ThreadValues values_;
  std::vector<std::vector<bool>> loops_;  // the nodes of each loop that has a barrier
  std::vector<Access> writes_;
  std::vector<Access> reads_;
};

}  // namespace

std::vector<hlsl::Diagnostic> missing_barrier_findings(const LintedCode& linted) {
  const auto& all = linted.code.instructions();
  const bool shares = std::any_of(all.begin(), all.end(), [](const spirv::Instruction& any) {
    return any.op == spv::OpVariable && any.operands[0] == spv::StorageClassWorkgroup;
  });
  if (!shares || std::any_of(all.begin(), all.end(), is_wave_operation)) return {};
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : linted.code.functions()) {
    if (function.blocks.empty()) continue;
    for (hlsl::Diagnostic& finding : SharedMemory(linted, function).findings())
      findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace penumbra::lint
