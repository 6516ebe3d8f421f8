#pragma once

// The one way to qpdf's classes. Its header on JSON, which nothing here needs, holds a vector of a
// class that is not complete, which Clang 14 refuses in C++20.
#if defined(__clang__) && __clang_major__ < 15 && !defined(JSON_HH)
#define JSON_HH
class JSON;
#endif
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFExc.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
