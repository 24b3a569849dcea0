#include "probe/PlotMarks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fpm {

namespace {

constexpr double textSize = 11, radius = 4.5;

struct Box {
    double left, top, right, bottom;
    double overlap(const Box& other) const
    {
        const double width = std::min(right, other.right) - std::max(left, other.left);
        const double height = std::min(bottom, other.bottom) - std::max(top, other.top);
        return width > 0 && height > 0 ? width * height : 0;
    }
};

Box boxOf(Pixel at)
{
    return {at.x - radius, at.y - radius, at.x + radius, at.y + radius};
}

/// Where a text may stand beside its mark.
struct Seat {
    double dx, dy;
    Anchor anchor;
};
// Errors fall to the right, so lines leave the corners above right and below left free.
constexpr std::array<Seat, 12> seats{{{7, -6, Anchor::start},
                                      {9, 4, Anchor::start},
                                      {-7, 14, Anchor::end},
                                      {-9, 4, Anchor::end},
                                      {0, -10, Anchor::middle},
                                      {0, 19, Anchor::middle},
                                      {7, 14, Anchor::start},
                                      {-7, -6, Anchor::end},
                                      {7, -20, Anchor::start},
                                      {-7, 28, Anchor::end},
                                      {7, 28, Anchor::start},
                                      {-7, -20, Anchor::end}}};
constexpr Seat beside{9, 4, Anchor::start}, before{-9, 4, Anchor::end}; // of a line of its own

Box textBox(Pixel at, const Seat& seat, const std::string& text)
{
    const double width = textWidth(text, textSize);
    const double shift = seat.anchor == Anchor::start    ? 0
                         : seat.anchor == Anchor::middle ? width / 2
                                                         : width;
    const double left = at.x + seat.dx - shift, base = at.y + seat.dy;
    return {left, base - 9, left + width, base + 2};
}

/// Length of a stroke within a box (Liang and Barsky 1984).
double lengthWithin(const Box& box, const Stroke& stroke)
{
    const double dx = stroke.to.x - stroke.from.x, dy = stroke.to.y - stroke.from.y;
    double first = 0, last = 1;
    const auto cut = [&](double step, double room) {
        if (step == 0) return room >= 0;
        const double at = room / step;
        if (step < 0)
            first = std::max(first, at);
        else
            last = std::min(last, at);
        return first < last;
    };
    const bool isIn = cut(-dx, stroke.from.x - box.left) && cut(dx, box.right - stroke.from.x)
                      && cut(-dy, stroke.from.y - box.top) && cut(dy, box.bottom - stroke.from.y);
    return isIn ? (last - first) * std::hypot(dx, dy) : 0;
}

double distance(const Box& box, Pixel at)
{
    return std::hypot(std::max({box.left - at.x, at.x - box.right, 0.0}),
                      std::max({box.top - at.y, at.y - box.bottom, 0.0}));
}

/// Marks that a text would seem to belong to as much as to its own.
std::size_t ambiguities(const Box& box, Pixel own, const std::vector<PlacedMark>& marks)
{
    constexpr double clearly = 2;
    const double near = distance(box, own) + clearly;
    return std::size_t(std::count_if(marks.begin(), marks.end(), [&](const PlacedMark& mark) {
        const bool isOwn = mark.at.x == own.x && mark.at.y == own.y;
        return !isOwn && distance(box, mark.at) < near;
    }));
}

/// How bad a place is, in pixels covered.
double coveredBy(const Box& box,
                 const std::vector<Box>& taken,
                 const std::vector<Stroke>& curves,
                 const Box& frame)
{
    double sum = 0;
    for (const Box& other : taken) sum += box.overlap(other);
    for (const Stroke& stroke : curves) sum += 2 * lengthWithin(box, stroke); // as wide as they are
    const double area = (box.right - box.left) * (box.bottom - box.top);
    return sum + 10 * (area - box.overlap(frame)); // outside is worse than over another
}

void drawMark(SvgDrawing& svg, const PlacedMark& mark)
{
    const std::string stroke = "stroke=\"" + mark.colour + "\" stroke-width=\"1.5\"";
    if (mark.barFrom < mark.barTo) {
        svg.line({mark.barFrom, mark.at.y}, {mark.barTo, mark.at.y}, stroke);
        for (const double x : {mark.barFrom, mark.barTo})
            svg.line({x, mark.at.y - 4}, {x, mark.at.y + 4}, stroke);
    }
    const auto circle = [&](double r, const std::string& attributes) {
        svg.element("<circle cx=\"" + svgNumber(mark.at.x) + "\" cy=\"" + svgNumber(mark.at.y)
                    + "\" r=\"" + svgNumber(r) + "\" " + attributes + "/>");
    };
    circle(3.6, mark.mark.hollow ? "fill=\"#ffffff\" " + stroke : "fill=\"" + mark.colour + "\"");
    if (mark.mark.emphasised) circle(6.5, "fill=\"none\" stroke=\"#1f2937\" stroke-width=\"1.2\"");
}

} // namespace

void drawMarks(SvgDrawing& svg,
               std::vector<PlacedMark> marks,
               const std::vector<Stroke>& curves,
               Pixel upperLeft,
               Pixel lowerRight)
{
    const Box frame{upperLeft.x, upperLeft.y, lowerRight.x, lowerRight.y};
    std::vector<Box> taken;
    double line = upperLeft.y + unknownLine / 2;
    for (PlacedMark& mark : marks) {
        if (!std::isfinite(mark.mark.y)) mark.at.y = line, line += unknownLine;
        taken.push_back(boxOf(mark.at));
    }
    for (const PlacedMark& mark : marks) {
        drawMark(svg, mark);
        if (mark.mark.text.empty()) continue;
        const bool isKnown = std::isfinite(mark.mark.y);
        Seat best = beside;
        double least = 1e300;
        for (const Seat& seat : isKnown ? std::vector<Seat>(seats.begin(), seats.end())
                                        : std::vector<Seat>{beside, before}) {
            const Box box = textBox(mark.at, seat, mark.mark.text);
            constexpr double asBadAs = 100; // pixels covered
            const double covered = coveredBy(box, taken, curves, frame)
                                   + asBadAs * double(ambiguities(box, mark.at, marks));
            if (covered < least) best = seat, least = covered;
        }
        taken.push_back(textBox(mark.at, best, mark.mark.text));
        svg.text({mark.at.x + best.dx, mark.at.y + best.dy}, mark.mark.text,
                 {textSize, best.anchor, readableColour(mark.colour), false, 0, true});
    }
}

} // namespace fpm
