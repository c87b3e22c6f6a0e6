#ifndef QUADTREE_MESH_2_EXAMPLES_RESUME_HINT_H
#define QUADTREE_MESH_2_EXAMPLES_RESUME_HINT_H

#include <signal.h>
#include <unistd.h>

#include <cstddef>
#include <string>

/// While it lives, a signal that ends the program tells where work can go on. The signal then acts as it would have.
class Resume_hint {
public:
  /// \param state the file from which work can go on, once it is there
  explicit Resume_hint(const std::string& state) {
    file() = state;
    text() =
        "\nquality_mesh: stopped; the state so far is in " + state + ", and --resume goes on from there\n";
    struct sigaction tell {};
    tell.sa_handler = [](int signal) {
      if (access(file().c_str(), F_OK) == 0)
        static_cast<void>(!write(STDERR_FILENO, text().data(), text().size()));
      raise(signal); // with its usual action, once this returns
    };
    tell.sa_flags = static_cast<int>(SA_RESETHAND);
    for (std::size_t i = 0; i < 2; ++i) {
      sigaction(signals_[i], nullptr, &before_[i]);
      if (before_[i].sa_handler != SIG_IGN) sigaction(signals_[i], &tell, nullptr);
    }
  }
  Resume_hint(const Resume_hint&) = delete;
  Resume_hint& operator=(const Resume_hint&) = delete;
  ~Resume_hint() {
    for (std::size_t i = 0; i < 2; ++i) sigaction(signals_[i], &before_[i], nullptr);
  }

private:
  static constexpr int signals_[] = {SIGINT, SIGTERM};
  struct sigaction before_[2] = {};

  // A handler can have no other places.
  static std::string& file() {
    static std::string name;
    return name;
  }
  static std::string& text() {
    static std::string hint;
    return hint;
  }
};

#endif // QUADTREE_MESH_2_EXAMPLES_RESUME_HINT_H
