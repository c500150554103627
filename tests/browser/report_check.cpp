#include "browser/report_check.h"

#include <charconv>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "browser/probe_script.h"
#include "input/input_error.h"
#include "platform/child_process.h"

namespace penumbra::browser {
namespace {

// A new folder for one run: the probed copy, and a browser profile nobody has used before.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::random_device random;
    path_ = std::filesystem::temp_directory_path() /
            ("penumbra-page-check-" + std::to_string(random()) + std::to_string(random()));
    std::filesystem::create_directory(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;  // the browser's last process may still be closing its files
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string with_probe(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string(), "cannot be opened");
  std::string html{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t head = html.find("<head>");
  if (head == std::string::npos) throw InputError(file.string(), "has no <head>: it is no report");
  html.insert(head + 6, kProbe);
  return html;
}

platform::ChildResult browse(const std::filesystem::path& page, const std::filesystem::path& profile) {
  if (!platform::find_program("chromium")) {
    throw EnvironmentError(
        "chromium is needed to open the report and is not installed\n  apt-get install chromium");
  }
  platform::ChildCommand command{"chromium", {}, {}};
  command.arguments = {"--headless",
                       "--no-sandbox",
                       "--disable-gpu",
                       "--disable-quic",
                       "--no-first-run",
                       "--disable-background-networking",
                       "--disable-component-update",
                       "--disable-sync",
                       "--disable-dev-shm-usage",
                       "--host-resolver-rules=MAP * ~NOTFOUND",
                       "--enable-logging=stderr",
                       "--window-size=1280,900",
                       "--user-data-dir=" + profile.string(),
                       "--virtual-time-budget=10000",
                       "--dump-dom",
                       "file://" + page.string()};
  command.timeout = std::chrono::seconds(60);
  platform::ChildResult result = platform::run_child(command);
  if (result.timed_out) throw EnvironmentError("chromium gave no answer within 60 s");
  return result;
}

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, value, 16).ec == std::errc()) {
      decoded += static_cast<char>(value);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

// The browser's own log repeats what the page wrote to its console, and knows a few errors no script sees.
void add_console_lines(const std::string& log, PageCheck& check) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(":CONSOLE") != std::string::npos) check.problems.push_back("browser log: " + line);
  }
}

}  // namespace

PageCheck check_page(const std::filesystem::path& html_file) {
  const TemporaryFolder folder;
  const std::filesystem::path page = folder.path() / "page.html";
  std::ofstream(page, std::ios::binary) << with_probe(html_file);
  const platform::ChildResult result = browse(page, folder.path() / "profile");

  PageCheck check;
  const std::size_t begin = result.output.rfind(kAnswerBegin);
  const std::size_t end = result.output.find(kAnswerEnd, begin == std::string::npos ? 0 : begin);
  if (begin == std::string::npos || end == std::string::npos) {
    throw EnvironmentError("chromium did not run the page to its end (exit code " +
                           std::to_string(result.exit_code) + "):\n" + result.errors.substr(0, 2000));
  }
  const std::size_t text = begin + kAnswerBegin.size();
  const auto answer = nlohmann::json::parse(percent_decoded(result.output.substr(text, end - text)));
  answer.at("problems").get_to(check.problems);
  answer.at("images").get_to(check.images);
  answer.at("charts").get_to(check.charts);
  answer.at("buttons").get_to(check.buttons);
  add_console_lines(result.errors, check);
  return check;
}

}  // namespace penumbra::browser
