#include <CLI/CLI.hpp>

#include "cli/archive_commands.h"

namespace tribolog::cli {

Run add_backup(CLI::App& archive) {
  const auto output = std::make_shared<std::string>();
  CLI::App& command = *archive.add_subcommand("backup", "write a copy to another file");
  command.add_option("-o,--output", *output, "file to write; must not exist yet")->required();
  const auto where = add_archive_options(command);
  command.footer("\nOthers may keep archiving meanwhile: the copy is a consistent snapshot.");
  return [where, output](const Invocation& call) {
    if (*output == "-") {
      throw UsageError("archive backup: a backup is a database and needs a file");
    }
    where->protect_from(*output);
    where->open(archive::sql::Access::read).backup(*output);
    call.console.say("backup: " + printable(*output, longest_path));
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
