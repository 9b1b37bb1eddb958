using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Closed contours whose first and last element are named. A ring begins and ends in one place, where these two meet. A named
/// lead-in or lead-out must pass through that place too; an unnamed one follows.</summary>
internal sealed class RingClosing(DisplacedElements elements, PathChange change, ElementJoints joints, RunEnds ends)
{
    /// <summary>Allowed distance of a displaced lead from the place where its ring closes, mm: the proof allows little besides
    /// rounding.</summary>
    private const double LeadMiss = 4e-6;

    private readonly NcPath _path = change.Path;

    /// <summary>A cut of the same contour that ends where a run begins, and one that begins where it ends: the contour closes there. -1 if
    /// there is none. A full circle needs no other cut to close.</summary>
    public (int Closing, int Opening) Closures(int first, int last, ContourSearch contours)
    {
        var (start, end) = (_path.Motions.StartOf(first), _path.Motions.EndOf(last));
        if (first == last && (start - end).Length < RunEnds.SamePlace)
        {
            return (-1, -1);
        }

        // A way in or out on which cutter compensation is switched begins or ends where the tool's center is, not on a contour.
        return (
            _path.Motions.SwitchesCompensation(first) ? -1 : contours.FirstEndingAt(start, first < last ? first : last + 1, first),
            _path.Motions.SwitchesCompensation(last) ? -1 : contours.LastStartingAt(end, first < last ? last : first - 1, last));
    }

    /// <summary>Closes the rings inside a run, and those that it closes with another named cut.</summary>
    /// <returns>The reason why one does not close, or null.</returns>
    public Refusal? Close(int first, int last, int closing, int opening)
    {
        foreach (var (start, end) in Rings.Inside(_path.Motions, first, last))
        {
            if (CloseRing(start, end - 1) is { } refusal)
            {
                return refusal;
            }
        }

        return (closing >= 0 && elements.Contains(closing) ? CloseRing(first, closing) : null)
            ?? (opening >= 0 && elements.Contains(opening) ? CloseRing(opening, last) : null);
    }

    /// <summary>The reason why a run must not go on from one pass in depth to the next, or null: there, an unnamed cut begins the pass
    /// above, or ends the one below. The way down moves alike at both of its ends, so these passes would no longer close.</summary>
    /// <param name="first">First motion of the run.</param>
    /// <param name="last">Last motion of the run.</param>
    /// <param name="contours">Finds where contours close.</param>
    public Refusal? OpenPass(int first, int last, ContourSearch contours)
    {
        var motions = _path.Motions;
        for (var joint = first + 1; joint <= last; joint++)
        {
            var (above, below) = (motions.EndOf(joint - 1), motions.StartOf(joint));
            if (above == below)
            {
                continue;
            }

            var opening = motions.StartOf(joint - 1) == above ? -1 : contours.LastStartingAt(above, joint - 1, joint - 1);
            var closing = motions.EndOf(joint) == below ? -1 : contours.FirstEndingAt(below, joint, joint);
            if (opening >= 0 && !elements.Contains(opening))
            {
                return Open(joint - 1, opening, joint, "closes the pass that begins with");
            }

            if (closing >= 0 && !elements.Contains(closing))
            {
                return Open(joint, closing, joint - 1, "begins the pass that ends with");
            }
        }

        return null;
    }

    private Refusal Open(int named, int unnamed, int other, string does) => elements.At(
        _path.Motions[named], NcRefusalCodes.NoIntersection,
        $"it {does} {elements.NameOf(unnamed)}, which is not named, and the tool goes straight down between it and "
            + $"{elements.NameOf(other)}. Displaced as asked, that pass would no longer close. Name the same cuts of each pass, and of "
            + "each pass those that meet there.");

    /// <summary>Moves both ends of a ring to where its last element meets its first.</summary>
    /// <param name="first">Its first motion; earlier motions of the same run lead in.</param>
    /// <param name="last">Its last motion; later motions of the same run lead out.</param>
    private Refusal? CloseRing(int first, int last)
    {
        var motion = _path.Motions[first];
        if (Closing(first, last) is not { } move)
        {
            return elements.At(
                motion,
                NcRefusalCodes.NoIntersection,
                $"displaced as asked, the contour no longer closes with {elements.NameOf(last)}: {joints.WhyApart(last, first)}");
        }

        if ((Lead(first - 1, "leads in to", first, last, move) ?? Lead(last + 1, "leads out of", first, last, move)) is { } refusal)
        {
            return refusal;
        }

        ends.Place(first, motion.Plane, move);
        ends.Place(last + 1, motion.Plane, move);
        return null;
    }

    // A joint that is a tangent point of a fillet stays there.
    private Vector2? Closing(int first, int last)
    {
        var plane = _path.Motions[first].Plane;
        foreach (var joint in (ReadOnlySpan<int>)[first, last + 1])
        {
            if (elements.IsRounded(joint) || elements.IsRounded(joint - 1))
            {
                return change.PlaneMoveOf(joint, plane);
            }
        }

        var amount = Math.Max(elements.WishOf(last).End.Length, elements.WishOf(first).Start.Length);
        return joints.Smooth(last, first)
            ?? (joints.Meet(last, first, first, amount) is { } point ? point - _path.Motions[first].PlaneStart : null);
    }

    // Refuses a named lead of a ring if, once displaced, it does not pass through the place where the ring closes.
    private Refusal? Lead(int lead, string does, int first, int last, Vector2 move)
    {
        if (!elements.Contains(lead)
            || elements.CarrierOf(lead).Distance(_path.Motions[first].PlaneStart + move) is var miss && miss <= LeadMiss)
        {
            return null;
        }

        var (begin, end) = (elements.NameOf(first), elements.NameOf(last));
        var ring = first == last ? begin : $"{begin} to {end}";
        return elements.At(_path.Motions[lead], NcRefusalCodes.NoIntersection, FormattableString.Invariant(
            $"it {does} the closed contour {ring}. Displaced as well, it would miss the place where that closes by {miss:0.0000} mm. ")
            + $"Leave it out: it follows by itself if {ring} alone is named.");
    }
}
