#include "experiments/host/private_directory.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

#include "experiments/process/tree.h"

namespace host {

PrivateDirectory::PrivateDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "matchday-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {  // makes it with mode 0700
    throw std::runtime_error("cannot make the directory " + name + ": " +
                             std::generic_category().message(errno));
  }
  path_ = name;
}

PrivateDirectory::~PrivateDirectory() { process::remove_tree(path_); }

}  // namespace host
