using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <content>
/// Closed contours whose first and last element are named. A ring begins and ends in one place, where these two meet. A named lead-in or
/// lead-out must pass through that place too; an unnamed one follows.
/// </content>
internal sealed partial class ElementDisplacer
{
    /// <summary>Allowed distance of a displaced lead from the place where its ring closes, mm: the proof allows little besides
    /// rounding.</summary>
    private const double LeadMiss = 4e-6;

    // A cut of the same contour that ends where a run begins, and one that begins where it ends: the contour closes there. -1 if there is
    // none. A full circle needs no other cut to close.
    private (int Closing, int Opening) Closures(int first, int last, ContourSearch contours)
    {
        var isRun = first < last;
        return (
            contours.FirstEndingAt(_path.Motions.StartOf(first), isRun ? first : last + 1, first),
            contours.LastStartingAt(_path.Motions.EndOf(last), isRun ? last : first - 1, first));
    }

    private Refusal? CloseRings(int first, int last, int closing, int opening)
    {
        foreach (var (start, end) in Rings.Inside(_path.Motions, first, last))
        {
            if (Close(start, end - 1) is { } refusal)
            {
                return refusal;
            }
        }

        return (closing >= 0 && _named.Contains(closing) ? Close(first, closing) : null)
            ?? (opening >= 0 && _named.Contains(opening) ? Close(opening, last) : null);
    }

    /// <summary>Moves both ends of a ring to where its last element meets its first.</summary>
    /// <param name="first">Its first motion; earlier motions of the same run lead in.</param>
    /// <param name="last">Its last motion; later motions of the same run lead out.</param>
    private Refusal? Close(int first, int last)
    {
        var motion = _path.Motions[first];
        if (Closing(first, last) is not { } move)
        {
            return At(motion, NcRefusalCodes.NoIntersection, $"displaced as asked, the contour no longer closes with {NameOf(last)}.");
        }

        if ((Lead(first - 1, "leads in to", first, last, move) ?? Lead(last + 1, "leads out of", first, last, move)) is { } refusal)
        {
            return refusal;
        }

        Place(first, motion.Plane, move);
        Place(last + 1, motion.Plane, move);
        return null;
    }

    // A joint that is a tangent point of a fillet stays there.
    private Vector2? Closing(int first, int last)
    {
        var plane = _path.Motions[first].Plane;
        foreach (var joint in (ReadOnlySpan<int>)[first, last + 1])
        {
            if (_rounded.ContainsKey(joint) || _rounded.ContainsKey(joint - 1))
            {
                return _change.PlaneMoveOf(joint, plane);
            }
        }

        var amount = Math.Max(WishOf(last).End.Length, WishOf(first).Start.Length);
        return Smooth(last, first) ?? (Meet(last, first, first, amount) is { } point ? point - _path.Motions[first].PlaneStart : null);
    }

    // Refuses a named lead of a ring if, once displaced, it does not pass through the place where the ring closes.
    private Refusal? Lead(int lead, string does, int first, int last, Vector2 move)
    {
        if (!_named.Contains(lead) || CarrierOf(lead).Distance(_path.Motions[first].PlaneStart + move) is var miss && miss <= LeadMiss)
        {
            return null;
        }

        var (begin, end) = (NameOf(first), NameOf(last));
        var ring = first == last ? begin : $"{begin} to {end}";
        return At(_path.Motions[lead], NcRefusalCodes.NoIntersection, FormattableString.Invariant(
            $"it {does} the closed contour {ring}. Displaced as well, it would miss the place where that closes by {miss:0.0000} mm. ")
            + $"Leave it out: it follows by itself if {ring} alone is named.");
    }

    private string NameOf(int motion) => _path.Program.NameOf(_path.Program[_path.Motions.BlockOf(motion)]);
}
