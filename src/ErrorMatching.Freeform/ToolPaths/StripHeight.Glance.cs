using System.Runtime.Intrinsics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <content>Tests four places at once, if one segment of each pass gives a sufficient bound.</content>
internal sealed partial class StripHeight
{
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
