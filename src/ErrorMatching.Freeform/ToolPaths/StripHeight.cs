using System.Runtime.Intrinsics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Measures the height of the material between two neighboring passes above the stage's required surface, along its normal. It
/// includes everything: ridge, chords, rounding.</summary>
/// <remarks>A ball that moves along the polyline removes a tube. A normal of the surface enters the tube of each pass somewhere; material
/// remains below both places. The ridge is where both are equally high. It is searched at every point of both polylines and halfway
/// between. Further passes and links between passes are ignored, so the true height is never larger. Most places do not need this search.
/// The height left by any one segment of each pass halfway between them is an upper bound of the ridge, and is mostly below the highest
/// ridge so far. Four places are tested at once.</remarks>
internal sealed class StripHeight(OffsetSurface offset, IReadOnlyList<CenterLine> edges, double scallopMm)
{
    private const int Corrections = 4;
    private static readonly double[] Across = [0.1, 0.3, 0.5, 0.7, 0.9];
    private int _hint;
    private int _otherHint;
    private Aim _aim;
    private Aim _otherAim;

    /// <summary>Returns the highest place between two passes, or the first one above the allowed scallop.</summary>
    /// <param name="first">Lines of one pass.</param>
    /// <param name="v">Its parameter.</param>
    /// <param name="second">Lines of the next pass.</param>
    /// <param name="next">Its parameter.</param>
    public (double Mm, Point2 Place) Measure(IReadOnlyList<CenterLine> first, double v, IReadOnlyList<CenterLine> second, double next)
    {
        var (highest, where) = (double.NegativeInfinity, default(Point2));
        Along(first, first, v, second, next, ref highest, ref where);
        Along(second, first, v, second, next, ref highest, ref where);
        return (highest, where);
    }

    private void Along(
        IReadOnlyList<CenterLine> lines,
        IReadOnlyList<CenterLine> first,
        double v,
        IReadOnlyList<CenterLine> second,
        double next,
        ref double highest,
        ref Point2 where)
    {
        foreach (var line in lines)
        {
            (_hint, _otherHint) = (0, 0);
            (_aim, _otherAim) = (default, default);
            var places = line.Places;
            var (samples, glances, lower) = ((2 * places.Length) - 1, Glances(first, second), 0u);
            for (var i = 0; i < samples && highest <= scallopMm; i++)
            {
                if (i % Vector256<double>.Count == 0)
                {
                    lower = 0;
                    if (glances && i + Vector256<double>.Count <= samples)
                    {
                        lower = Lower(
                            Vector256.Create(Sample(places, i), Sample(places, i + 1), Sample(places, i + 2), Sample(places, i + 3)),
                            v + ((next - v) * 0.5),
                            first[0],
                            second[0],
                            highest);
                        (_hint, _otherHint) = (_aim.Piece, _otherAim.Piece);
                    }
                }

                if ((lower >> (i % Vector256<double>.Count) & 1) == 0)
                {
                    At(Sample(places, i), ref highest, ref where);
                }
            }
        }

        void At(double u, ref double highest, ref Point2 where)
        {
            var (a, b) = (Covering(first, u), Covering(second, u));
            var (height, at) = a is not null && b is not null ? Ridge(u, a, v, b, next, highest) : Open(u, a, b, v, next);
            if (height > highest)
            {
                (highest, where) = (height, new(u, at));
            }
        }
    }

    // Every point of a line, and halfway between two.
    private static double Sample(ReadOnlySpan<Point2> places, int i) =>
        (i & 1) == 0 ? places[i >> 1].X : (places[i >> 1].X + places[(i >> 1) + 1].X) / 2;

    private static CenterLine? Covering(IReadOnlyList<CenterLine> lines, double u)
    {
        for (var i = 0; i < lines.Count; i++)
        {
            if (lines[i].Covers(u))
            {
                return lines[i];
            }
        }

        return null;
    }

    // The ridge at u, or an upper bound that is no higher than the highest so far.
    private (double Mm, double V) Ridge(double u, CenterLine a, double v, CenterLine b, double next, double highest)
    {
        var (x, slope) = (0.5, 0.0);
        var (lastX, last) = (x, 0.0);
        for (var i = 0; ; i++)
        {
            var at = v + ((next - v) * x);
            if (!offset.Surface.Region.Contains(u, at))
            {
                return Open(u, a, b, v, next);
            }

            // One height rises from its pass and the other falls, so at any place the higher of both is an upper bound of the ridge.
            var (place, normal) = offset.Left(u, at);
            var (ta, tb) = (Leaves(place, normal, a, ref _hint), Leaves(place, normal, b, ref _otherHint));
            var (higher, difference) = (Math.Max(ta, tb), ta - tb);
            if (i == Corrections || higher <= highest || !(Math.Abs(difference) > 0.02 * scallopMm) || !double.IsFinite(difference))
            {
                return (higher, at);
            }

            // Both heights grow with the square of the distance from their pass. Over a strip of ridge h, their difference changes by 8 h.
            slope = i == 0 ? 8 * scallopMm : (difference - last) / (x - lastX);
            (lastX, last) = (x, difference);
            x = Math.Clamp(x - (difference / Math.Max(slope, scallopMm)), 0.02, 0.98);
            if (x == lastX)
            {
                return (higher, at);
            }
        }
    }

    // If a trimmed strip has only one pass, or its middle is outside, the pass along the region's edge is included.
    private (double Mm, double V) Open(double u, CenterLine? a, CenterLine? b, double v, double next)
    {
        var (highest, where) = (double.NegativeInfinity, v);
        foreach (var x in Across)
        {
            var at = v + ((next - v) * x);
            if (!offset.Surface.Region.Contains(u, at))
            {
                continue;
            }

            var (place, normal) = offset.Left(u, at);
            var height = Math.Min(
                a is null ? double.PositiveInfinity : Leaves(place, normal, a, ref _hint),
                b is null ? double.PositiveInfinity : Leaves(place, normal, b, ref _otherHint));
            height = Edges(place, normal, height);
            (highest, where) = height > highest ? (height, at) : (highest, where);
        }

        return (highest, where);
    }

    private double Edges(Point3 place, Vector3 normal, double enough)
    {
        foreach (var edge in edges)
        {
            for (var i = 0; i + 1 < edge.Count; i++)
            {
                enough = Math.Min(enough, LeavesPiece(place, normal, edge.Piece(i)).Mm);
            }
        }

        return enough;
    }

    /// <summary>How far along the normal the tube of a polyline starts; infinite if the normal misses it. Places near raised points are
    /// not measured.</summary>
    private double Leaves(Point3 place, Vector3 normal, CenterLine line, ref int hint)
    {
        var last = line.Count - 2;
        hint = Math.Min(hint, last);
        var best = double.PositiveInfinity;
        var from = 0;
        for (var steps = 0; steps < line.Count; steps++)
        {
            if (line.IsRaised(hint))
            {
                return double.NegativeInfinity;
            }

            var (height, side) = LeavesPiece(place, normal, line.Piece(hint));
            best = Math.Min(best, height);
            if (side == 0 || side == -from || hint + side < 0 || hint + side > last)
            {
                break;
            }

            (hint, from) = (hint + side, side);
        }

        return best;
    }

    // Where a ray enters the tube of one segment, and on which side of the segment it would enter earlier.
    private (double Mm, int Side) LeavesPiece(Point3 place, Vector3 normal, in CenterPiece piece)
    {
        var p = piece.From - place;
        if (piece.LengthMm > 0)
        {
            var (nAlong, pAlong) = (normal.Dot(piece.Along), p.Dot(piece.Along));
            var (n, q) = (normal - (piece.Along * nAlong), p - (piece.Along * pAlong));
            var (nn, nq) = (n.Dot(n), n.Dot(q));
            var inside = (nq * nq) - (nn * (q.Dot(q) - (offset.RadiusMm * offset.RadiusMm)));
            var t = inside >= 0 && nn > 0 ? (nq - Math.Sqrt(inside)) / nn : 0;
            var foot = (t * nAlong) - pAlong;
            if (foot >= 0 && foot <= piece.LengthMm)
            {
                return (inside >= 0 && nn > 0 ? t : double.PositiveInfinity, 0);
            }

            return foot < 0 ? (LeavesBall(normal, p), -1) : (LeavesBall(normal, piece.To - place), 1);
        }

        return (LeavesBall(normal, p), 0);
    }

    private double LeavesBall(Vector3 normal, Vector3 center)
    {
        var along = normal.Dot(center);
        var inside = (along * along) - center.Dot(center) + (offset.RadiusMm * offset.RadiusMm);
        return inside >= 0 ? along - Math.Sqrt(inside) : double.PositiveInfinity;
    }

    // Tests four places at once, if one segment of each pass gives a sufficient bound.

    // If the surface is not trimmed and nothing is raised, one line of each pass covers the whole strip, and every place of it is measured.
    private bool Glances(IReadOnlyList<CenterLine> first, IReadOnlyList<CenterLine> second) =>
        offset.Surface.Region.IsWhole
            && first.Count == 1
            && second.Count == 1
            && !first[0].HasRaised
            && !second[0].HasRaised
            && first[0].Count > 1
            && second[0].Count > 1;

    /// <summary>At which of four places in ascending order the ridge is surely not higher than a height, one bit each.</summary>
    private uint Lower(Vector256<double> u, double v, CenterLine a, CenterLine b, double mm)
    {
        if (!offset.Left(u, v, out var places, out var normals))
        {
            return 0;
        }

        // NaN is not lower.
        var heights = Vector256.Max(Leaves(places, normals, u, a, ref _aim), Leaves(places, normals, u, b, ref _otherAim));
        return Vector256.LessThanOrEqual(heights, Vector256.Create(mm)).ExtractMostSignificantBits();
    }

    /// <summary>How far along each normal the tube of a polyline starts, or an upper bound: only the segment that is probably hit first is
    /// evaluated.</summary>
    private Vector256<double> Leaves(in FourVectors places, in FourVectors normals, Vector256<double> u, CenterLine line, ref Aim aim)
    {
        var first = line.PieceAt(u[0] + aim.Ahead, aim.Piece);
        var second = line.PieceAt(u[1] + aim.Ahead, first);
        var third = line.PieceAt(u[2] + aim.Ahead, second);
        var fourth = line.PieceAt(u[3] + aim.Ahead, third);
        line.Pieces(first, second, third, fourth, out var from, out var along, out var length);

        // Same formula as for one place and one segment. A segment without length is a ball.
        var p = from - places;
        var (nAlong, pAlong) = (normals.Dot(along), p.Dot(along));
        var (n, q) = (normals - (along * nAlong), p - (along * pAlong));
        var (nn, nq) = (n.Dot(n), n.Dot(q));
        var radius = Vector256.Create(offset.RadiusMm * offset.RadiusMm);
        var inside = (nq * nq) - (nn * (q.Dot(q) - radius));
        var t = (nq - Vector256.Sqrt(inside)) / nn;
        var foot = (t * nAlong) - pAlong;
        var end = Vector256.Min(Vector256.Max(foot, Vector256<double>.Zero), length);
        if (!Vector256.EqualsAll(end, foot))
        {
            // Beyond an end, or where the normal misses the tube, only the ball at that end is certain.
            var center = p + (along * end);
            var over = normals.Dot(center);
            var inBall = (over * over) - center.Dot(center) + radius;
            t = Vector256.ConditionalSelect(Vector256.Equals(end, foot), t, over - Vector256.Sqrt(inBall));
        }

        var (before, behind) = (line.Places[fourth].X, line.Places[fourth + 1].X);
        var ahead = before + ((behind - before) * (foot[3] / length[3])) - u[3];
        aim = new(first, double.IsFinite(ahead) ? ahead : 0);
        return t;
    }

    /// <summary>Where on a pass the tube is probably hit.</summary>
    /// <param name="Piece">The segment for the first of four places.</param>
    /// <param name="Ahead">How far ahead of the place, in the parameter.</param>
    private readonly record struct Aim(int Piece, double Ahead);
}
