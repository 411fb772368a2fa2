#include "engine/record/checkpoint.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "engine/record/fnv_hash.h"

namespace dda {
namespace {

// The file: this header, the state, the extra bytes, and the FNV-1a hash of all that.
struct Header {
  std::array<char, 8> magic{'D', 'D', 'A', 'S', 'T', 'A', 'T', 'E'};
  std::uint32_t version = 2;  // outlines are in local places since this one (ADR 102)
  std::uint32_t byte_order = 0x01020304;
  std::uint64_t scene = 0;       // fingerprint of the model
  std::uint64_t file_bytes = 0;  // of the whole file
  std::uint64_t blocks = 0;
  std::uint64_t extra_bytes = 0;
};
static_assert(std::has_unique_object_representations_v<Header>, "the header is written as it lies in memory");

std::uint64_t file_bytes(const State& state, std::uint64_t extra_bytes) {
  std::uint64_t total = sizeof(Header) + extra_bytes + sizeof(std::uint64_t);
  visit_memory(state, [&](const void*, std::size_t count) { total += count; });
  return total;
}

State blank_state(std::size_t blocks) {
  State state;
  state.displacement.resize(blocks);
  state.velocity.resize(blocks);
  state.acceleration.resize(blocks);
  state.stress.resize(blocks);
  state.deformation.resize(blocks);
  return state;
}

std::uint64_t hash_of(std::string_view bytes) {
  FnvHash hash;
  hash.add(bytes);
  return hash.value();
}

template <typename Value>
Value read_value(std::string_view bytes, std::size_t offset) {
  Value value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

class Refusal {
 public:
  explicit Refusal(const std::filesystem::path& path) : path_(path.string()) {}
  void operator()(bool refused, const std::string& value, const std::string& expected) const {
    if (refused) throw InputError(path_, "checkpoint", value, expected);
  }

 private:
  std::string path_;
};

std::string read_bytes(const std::filesystem::path& path) {
  try {
    return read_file(path);
  } catch (const UnreadableFile& error) {
    throw InputError(path.string(), "checkpoint", error.why(), "a readable file");
  }
}

Header checked_header(std::string_view bytes, const Refusal& refuse_if) {
  const Header ours;
  refuse_if(!bytes.starts_with(std::string_view(ours.magic.data(), ours.magic.size())), "some other kind of file",
            "one that starts with DDASTATE");
  refuse_if(bytes.size() < sizeof(Header), fmt::format("cut off after {} bytes", bytes.size()), "a whole file");
  const auto header = read_value<Header>(bytes, 0);
  refuse_if(header.byte_order != ours.byte_order, "of a machine with another byte order", "one of this machine's");
  refuse_if(header.version != ours.version, fmt::format("of version {}", header.version),
            fmt::format("version {}", ours.version));
  refuse_if(header.file_bytes != bytes.size(), fmt::format("{} bytes long", bytes.size()),
            fmt::format("{} bytes, a whole file", header.file_bytes));
  const std::size_t body = bytes.size() - sizeof(std::uint64_t);
  refuse_if(body < sizeof(Header) || hash_of(bytes.substr(0, body)) != read_value<std::uint64_t>(bytes, body),
            "damaged (its checksum does not fit)", "an intact file");
  return header;
}

}  // namespace

// From where it lies: a copy of the whole would be half a kilobyte a block.
void save_checkpoint(const std::filesystem::path& path, const Model& model, const State& state,
                     std::initializer_list<std::span<const std::byte>> extra) {
  Header header;
  header.scene = fingerprint(model);
  header.blocks = state.displacement.size();
  for (const auto& part : extra) header.extra_bytes += part.size();
  header.file_bytes = file_bytes(state, header.extra_bytes);

  AtomicFile file(path);
  FnvHash hash;
  const auto append = [&](const void* from, std::size_t count) {
    const std::string_view bytes(static_cast<const char*>(from), count);
    hash.add(bytes);
    file.write(bytes);
  };
  append(&header, sizeof header);
  visit_memory(state, append);
  for (const auto& part : extra) append(part.data(), part.size());
  const std::uint64_t checksum = hash.value();
  append(&checksum, sizeof checksum);
  file.commit(Survives::power_cut);
}

Checkpoint load_checkpoint(const std::filesystem::path& path, const Model& model) {
  const std::string bytes = read_bytes(path);
  const Refusal refuse_if(path);
  const Header header = checked_header(bytes, refuse_if);
  refuse_if(header.scene != fingerprint(model) || header.blocks != model.blocks.size(),
            fmt::format("of another scene or other records (it has {} blocks)", header.blocks),
            fmt::format("one with the {} blocks, the materials, the joints and the records of this scene",
                        model.blocks.size()));

  Checkpoint checkpoint{blank_state(model.blocks.size()), {}};
  refuse_if(file_bytes(checkpoint.state, header.extra_bytes) != bytes.size(), "damaged (its sizes do not fit)",
            "an intact file");
  checkpoint.extra.resize(header.extra_bytes);
  std::size_t offset = sizeof header;
  const auto take = [&](void* to, std::size_t count) {
    if (count > 0) std::memcpy(to, bytes.data() + offset, count);
    offset += count;
  };
  visit_memory(checkpoint.state, take);
  take(checkpoint.extra.data(), checkpoint.extra.size());
  return checkpoint;
}

}  // namespace dda
