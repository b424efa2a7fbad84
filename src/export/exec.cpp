#include <heed/export/exec.h>
#include <heed/export/runner.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <istream>
#include <iterator>
#include <optional>
#include <ostream>

#include "observation.h"
#include "reaction.h"

namespace heed::exporter {
namespace {

struct Fault {
  std::string error, hint;
};

/// What the user can do about a missing row: the assumptions, as many as a line bears.
std::string missing_row_hint(const model::Mealy& machine) {
  constexpr std::size_t most = 3;
  if (machine.assumptions.empty()) return "what it was synthesized from does not allow this observation now";
  std::string hint = "the controller relies on: ";
  for (std::size_t i = 0; i < std::min(most, machine.assumptions.size()); ++i)
    hint += (i == 0 ? "" : "; ") + machine.assumptions[i];
  if (machine.assumptions.size() > most)
    hint += fmt::format("; and {} more", machine.assumptions.size() - most);
  return hint;
}

}  // namespace

class LineExecutor::Impl {
 public:
  explicit Impl(model::Mealy machine)
      : reader_(machine.inputs), writer_(machine), runner_(checked(std::move(machine))) {}

  std::string line(std::string_view json) {
    if (json.size() > max_line)
      return answer_fault({fmt::format("the line is longer than {} bytes", max_line),
                           "send one observation a line; a line ends with a line feed"});
    LineReading reading = reader_.read(json);
    if (reading.kind == LineReading::Kind::Reset) return reset();
    if (reading.kind == LineReading::Kind::Error)
      return answer_fault({std::move(reading.error), std::move(reading.hint)});
    const std::optional<std::uint32_t> letter = runner_.letter(reading.observation);
    if (!letter || !runner_.answers(*letter))
      return answer_fault({"no row for this observation: the controller does not know what to do here",
                           missing_row_hint(runner_.machine())});
    const bool fallback = take(*letter);
    if (!fallback) legal_ = letter;
    std::string out = head();
    return close(out, fallback ? "the observation breaks an assumption" : nullptr);
  }

 private:
  static model::Mealy checked(model::Mealy machine) {
    if (machine.state_count() == 0)
      throw util::InputError({}, "no-states", "the controller has no states", "");
    return machine;
  }

  std::string reset() {
    runner_.reset();
    step_ = 0;
    legal_.reset();
    reaction_ = nullptr;
    return "{\"reset\": true}";
  }

  /// Steps on a letter that has a row; whether that row is a fallback.
  bool take(std::uint32_t letter) {
    const Runner::Answer answer = runner_.step_letter(letter);
    reaction_ = &runner_.machine().output_letters[answer.output];
    return answer.status == Status::Fallback;
  }

  std::string answer_fault(const Fault& fault) {
    const char* note = reaction_ != nullptr ? "the last reaction is repeated" : "there is no reaction yet";
    if (legal_ && runner_.answers(*legal_)) {
      take(*legal_);
      note = "answered as the last legal observation would be";
    }
    std::string out = head();
    out += ", \"error\": " + json_quoted(fault.error) + ", \"hint\": " + json_quoted(fault.hint);
    return close(out, note);
  }

  std::string head() { return fmt::format("{{\"step\": {}", step_++); }

  /// \param note  Which fallback this is; nullptr: none.
  std::string close(std::string& out, const char* note) const {
    writer_.append(out, reaction_);
    out += ", \"fallback\": ";
    out += note != nullptr ? "true, \"note\": \"" : "false";
    if (note != nullptr) (out += note) += '"';
    out += '}';
    return std::move(out);
  }

  ObservationReader reader_;
  ReactionWriter writer_;
  Runner runner_;
  std::uint64_t step_ = 0;
  std::optional<std::uint32_t> legal_;          ///< The last letter that a row not marked as fallback took.
  const model::Valuation* reaction_ = nullptr;  ///< The last reaction, in the machine.
};

LineExecutor::LineExecutor(model::Mealy machine) : impl_(std::make_unique<Impl>(std::move(machine))) {}
LineExecutor::~LineExecutor() = default;
LineExecutor::LineExecutor(LineExecutor&&) noexcept = default;
LineExecutor& LineExecutor::operator=(LineExecutor&&) noexcept = default;

std::string LineExecutor::line(std::string_view json) {
  return impl_->line(json);
}

void LineExecutor::run(std::istream& in, std::ostream& out) {
  constexpr int end = std::char_traits<char>::eof();
  std::streambuf& source = *in.rdbuf();
  std::string text;
  for (int c = source.sbumpc(); c != end && out; c = source.sbumpc()) {
    text.clear();
    for (; c != end && c != '\n' && text.size() <= max_line; c = source.sbumpc())
      text += static_cast<char>(c);
    out << line(text) << '\n';
    const bool cut = c != end && c != '\n';
    if (cut || source.in_avail() <= 0) out.flush();
    while (c != end && c != '\n') c = source.sbumpc();
    if (c == end) break;
  }
  out.flush();
}

}  // namespace heed::exporter
