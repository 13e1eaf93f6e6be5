#include "isolaw/data/files/table.hpp"

#include <fmt/format.h>

namespace isolaw::data {

void FirstComplaints::add(std::size_t line, std::string found, std::string allowed, std::string advice) {
  ++count_;
  if (first_.size() < shown)
    first_.push_back({fmt::format("{}:{}", file_, line), std::move(found), std::move(allowed), std::move(advice)});
}

void FirstComplaints::append_to(std::vector<Complaint>& complaints) const {
  complaints.insert(complaints.end(), first_.begin(), first_.end());
  if (count_ > first_.size())
    complaints.push_back({file_, fmt::format("and {} more {}", count_ - first_.size(), rest_), {}, {}});
}

}  // namespace isolaw::data
