double breach_avx512(double const*);
double breach_plain(double const*);

int main(int count, char**) {
  double values[1024] = {static_cast<double>(count)};
  return breach_avx512(values) > breach_plain(values) ? 1 : 0;
}
