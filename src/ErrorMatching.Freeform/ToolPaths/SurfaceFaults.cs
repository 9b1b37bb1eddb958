using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Finds what no ball can follow: edges in the surface, and places without a normal or facing down.</summary>
/// <param name="context">What the path is planned with.</param>
internal sealed class SurfaceFaults(PlanningContext context)
{
    /// <summary>Why a line of centers cannot be cut, or null.</summary>
    public Refusal? Impossible(CenterLine line)
    {
        for (var i = 0; i < line.Count; i++)
        {
            var normal = line.Normals[i];
            if (!line.Centers[i].IsFinite || !(normal.Length > 0.5))
            {
                return new(
                    "no-normal",
                    $"at {context.Named(line.Places[i])} the surface has no normal, so that no tool can be laid against it. Repair the "
                        + $"surface, or trim it there.");
            }

            if (normal.Z < -1e-6)
            {
                return new(
                    "faces-down",
                    $"at {context.Named(line.Places[i])} the surface faces down, where a tool along Z does not reach. Turn the part, or "
                        + $"state \"outside\" if the material lies on the other side.");
            }
        }

        return null;
    }

    /// <summary>An edge inside the surface, where the normal jumps. The center would have to roll around it.</summary>
    public Refusal? EdgeInSurface()
    {
        var spline = context.Offset.Surface.Spline;
        return EdgeAt(spline.KnotsU, spline.KnotsV, (along, across) => new(across, along))
            ?? EdgeAt(spline.KnotsV, spline.KnotsU, (along, across) => new(along, across));
    }

    private Refusal? EdgeAt(KnotVector knots, KnotVector along, Func<double, double, Point2> place)
    {
        const int Samples = 32;
        foreach (var knot in knots.Breaks)
        {
            if (knots.Multiplicity(knot) < knots.Degree || knot <= knots.Start || knot >= knots.End)
            {
                continue;
            }

            for (var i = 0; i <= Samples; i++)
            {
                var t = along.Start + ((along.End - along.Start) * i / Samples);
                var (before, behind) = (place(t, knot - (1e-9 * (knots.End - knots.Start))), place(t, knot));
                var turn = (context.Offset.At(before.X, before.Y).Normal - context.Offset.At(behind.X, behind.Y).Normal).Length;
                if (turn * context.Offset.DistanceMm > 0.5 * context.Toolpath.ChordMm)
                {
                    return new("edge-in-surface", string.Create(
                        CultureInfo.InvariantCulture,
                        $"at {context.Named(behind)} the surface has an edge: its normal turns by "
                            + $"{2 * Elementary.Asin(Math.Min(1, turn / 2)) * 180 / Math.PI:0.000} degrees at once. Give the faces on both "
                                + $"sides as "
                            + $"surfaces of their own."));
                }
            }
        }

        return null;
    }
}
