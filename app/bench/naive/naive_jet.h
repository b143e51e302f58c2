// A number with its derivatives by x up to order O, in Eigen's double: the second stage of the naive evaluation.
#pragma once

#include <Eigen/Dense>
#include <type_traits>

namespace bench {

struct NoDerivative {};

template <int O>
struct NaiveJet {
    double v = 0;
    [[no_unique_address]] std::conditional_t<(O >= 1), Eigen::Vector3d, NoDerivative> g;
    [[no_unique_address]] std::conditional_t<(O >= 2), Eigen::Matrix3d, NoDerivative> h;

    NaiveJet() {
        if constexpr (O >= 1)
            g.setZero();
        if constexpr (O >= 2)
            h.setZero();
    }
    NaiveJet& operator+=(const NaiveJet& o) {
        v += o.v;
        if constexpr (O >= 1)
            g += o.g;
        if constexpr (O >= 2)
            h += o.h;
        return *this;
    }
    /// += weight * factor, the factor a constant.
    void add(const NaiveJet& weight, double factor) {
        v += weight.v * factor;
        if constexpr (O >= 1)
            g += weight.g * factor;
        if constexpr (O >= 2)
            h += weight.h * factor;
    }
    /// += other * x_k, x taken from where it is: its value there is 0.
    void addTimesCoordinate(const NaiveJet& other, int k) {
        if constexpr (O >= 1)
            g[k] += other.v;
        if constexpr (O >= 2) {
            h.row(k) += other.g.transpose();
            h.col(k) += other.g;
        }
    }
};

template <int O>
NaiveJet<O> operator*(const NaiveJet<O>& a, const NaiveJet<O>& b) {
    NaiveJet<O> out;
    out.v = a.v * b.v;
    if constexpr (O >= 1)
        out.g = a.g * b.v + b.g * a.v;
    if constexpr (O >= 2)
        out.h = a.h * b.v + b.h * a.v + a.g * b.g.transpose() + b.g * a.g.transpose();
    return out;
}

/// f(a) with f, f', f'' at a.
template <int O>
NaiveJet<O> chain(const NaiveJet<O>& a, double f, double f1, double f2) {
    NaiveJet<O> out;
    out.v = f;
    if constexpr (O >= 1)
        out.g = f1 * a.g;
    if constexpr (O >= 2)
        out.h = f1 * a.h + f2 * a.g * a.g.transpose();
    return out;
}

template <int O>
NaiveJet<O> inverse(const NaiveJet<O>& a) {
    const double i = 1 / a.v;
    return chain(a, i, -i * i, 2 * i * i * i);
}

template <int O>
NaiveJet<O> inverseRoot(const NaiveJet<O>& a) {
    const double i = 1 / std::sqrt(a.v);
    return chain(a, i, -0.5 * i / a.v, 0.75 * i / (a.v * a.v));
}

} // namespace bench
