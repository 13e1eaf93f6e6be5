// A stand-in for the part of OpenSees that an exported material uses: the same signatures, with the least code that
// makes them work. It was written from the interface and contains no text of OpenSees.
#pragma once

#include <cstdlib>
#include <deque>
#include <sstream>
#include <string>
#include <vector>

class OPS_Stream {
 public:
  template <class T>
  OPS_Stream& operator<<(T const& value) {
    text << value;
    return *this;
  }
  std::ostringstream text;
};
inline OPS_Stream errors;
inline OPS_Stream* opserrPtr = &errors;
#define opserr (*opserrPtr)
#define OPS_PRINT_PRINTMODEL_JSON 25000

class ID {
 public:
  explicit ID(int size) : numbers(static_cast<std::size_t>(size)) {}
  int& operator()(int i) { return numbers.at(static_cast<std::size_t>(i)); }
  int operator()(int i) const { return numbers.at(static_cast<std::size_t>(i)); }
  std::vector<int> numbers;
};

// A view of numbers that another object owns.
class Vector {
 public:
  Vector(double* data, int size) : data_(data), size_(size) {}
  int Size() const { return size_; }
  double* begin() const { return data_; }

 private:
  double* data_;
  int size_;
};

class ChannelAddress;
class Channel {
 public:
  virtual ~Channel() = default;
  virtual int sendVector(int, int, Vector const&, ChannelAddress* = nullptr) = 0;
  virtual int recvVector(int, int, Vector&, ChannelAddress* = nullptr) = 0;
  virtual int sendID(int, int, ID const&, ChannelAddress* = nullptr) = 0;
  virtual int recvID(int, int, ID&, ChannelAddress* = nullptr) = 0;
};

// Stores messages first in, first out. As in OpenSees, it is an error to receive a message of another length than was
// sent.
class Memory : public Channel {
 public:
  int sendVector(int, int, Vector const& x, ChannelAddress*) override {
    vectors.emplace_back(x.begin(), x.begin() + x.Size());
    return 0;
  }
  int recvVector(int, int, Vector& x, ChannelAddress*) override {
    if (vectors.empty() || static_cast<int>(vectors.front().size()) != x.Size()) return -1;
    for (int i = 0; i < x.Size(); ++i) x.begin()[i] = vectors.front()[static_cast<std::size_t>(i)];
    vectors.pop_front();
    return 0;
  }
  int sendID(int, int, ID const& x, ChannelAddress*) override {
    ids.push_back(x.numbers);
    return 0;
  }
  int recvID(int, int, ID& x, ChannelAddress*) override {
    if (ids.empty() || ids.front().size() != x.numbers.size()) return -1;
    x.numbers = ids.front();
    ids.pop_front();
    return 0;
  }
  std::deque<std::vector<double>> vectors;
  std::deque<std::vector<int>> ids;
};

class FEM_ObjectBroker {};
class SectionForceDeformation;

class Material {
 public:
  Material(int tag, int class_tag) : tag_(tag), class_tag_(class_tag) {}
  virtual ~Material() = default;
  int getTag() const { return tag_; }
  int getClassTag() const { return class_tag_; }
  virtual const char* getClassType() const { return "Material"; }
  int getDbTag() const { return 3; }
  virtual int sendSelf(int, Channel&) = 0;
  virtual int recvSelf(int, Channel&, FEM_ObjectBroker&) = 0;
  virtual void Print(OPS_Stream&, int = 0) = 0;

 protected:
  void setTag(int tag) { tag_ = tag; }

 private:
  int tag_, class_tag_;
};

class UniaxialMaterial : public Material {
 public:
  using Material::Material;

  virtual int setTrialStrain(double strain, double strainRate = 0) = 0;
  virtual int setTrialStrain(double strain, double, double strainRate) { return setTrialStrain(strain, strainRate); }
  virtual int setTrial(double, double&, double&, double = 0.0) { return -1; }
  virtual int setTrial(double, double, double&, double&, double&, double = 0.0) { return -1; }
  virtual double getStrain() = 0;
  virtual double getStrainRate() { return 0.0; }
  virtual double getStress() = 0;
  virtual double getTangent() = 0;
  virtual double getInitialTangent() = 0;
  virtual double getDampTangent() { return 0.0; }
  virtual int commitState() = 0;
  virtual int revertToLastCommit() = 0;
  virtual int revertToStart() = 0;
  virtual UniaxialMaterial* getCopy() = 0;
  virtual UniaxialMaterial* getCopy(SectionForceDeformation*) { return getCopy(); }
};

// `words` holds the words after the name of a command. If `python` is set, OPS_GetString() refuses a number, as
// OpenSees does when it is called from Python.
inline std::vector<std::string> words;
inline std::size_t next_word = 0;
inline bool python = false;
inline bool is_number(std::string const& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}
extern "C" {
inline int OPS_GetNumRemainingInputArgs() {
  return static_cast<int>(words.size() - next_word);
}
inline int OPS_ResetCurrentInputArg(int back) {
  next_word += static_cast<std::size_t>(back);
  return 0;
}
inline int OPS_GetDoubleInput(int*, double* value) {
  if (next_word >= words.size() || !is_number(words[next_word], *value)) return -1;
  ++next_word;
  return 0;
}
inline int OPS_GetIntInput(int* count, int* value) {
  double number = 0.0;
  if (OPS_GetDoubleInput(count, &number) != 0) return -1;
  *value = static_cast<int>(number);
  return *value == number ? 0 : -1;
}
inline char const* OPS_GetString() {
  double ignored = 0.0;
  if (next_word >= words.size()) return nullptr;
  auto const& word = words[next_word++];
  return python && is_number(word, ignored) ? nullptr : word.c_str();
}
}
