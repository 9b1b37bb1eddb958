using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>How well the points of a plan represent the nominal surface: its distance from a surface made of these points alone.</summary>
/// <remarks>The surface is piecewise cubic: Lagrange through the four nearest points of a curve, then through the four nearest curves,
/// never across a curvature break. This is a cautious substitute for the fits, which are smoother. It is compared with the nominal surface
/// at the midpoints and quarter points between points.</remarks>
internal sealed class PlanReconstruction
{
    private const int Support = 4;
    private static readonly double[] Fractions = [0, 0.25, 0.5, 0.75];

    private readonly PartSurface _surface;
    private readonly double[] _v;
    private readonly bool[] _isBreakV;
    private readonly double[][] _u;
    private readonly bool[][] _isBreakU;
    private readonly Point3[][] _points;

    public PlanReconstruction(PartSurface surface, IReadOnlyList<PlanCurve> curves)
    {
        _surface = surface;
        _v = [.. curves.Select(c => c.V)];
        _isBreakV = [.. curves.Select(c => c.Reason == PlanReason.Break)];
        _u = [.. curves.Select(c => c.Nodes.Select(n => n.U).ToArray())];
        _isBreakU = [.. curves.Select(c => c.Nodes.Select(n => n.Reason == PlanReason.Break).ToArray())];
        _points = [.. curves.Select(c => c.Nodes.Select(n => surface.Spline.PointAt(n.U, c.V)).ToArray())];
    }

    /// <summary>Largest distance along the normal, mm, on the curves themselves and everywhere.</summary>
    public (double OnCurvesMm, double EverywhereMm) ErrorMm()
    {
        var (onCurves, everywhere) = (0.0, 0.0);
        var longest = _u.MaxBy(u => u.Length)!;
        for (var j = 0; j < _v.Length; j++)
        {
            foreach (var fraction in j + 1 < _v.Length ? Fractions : [0])
            {
                var v = fraction == 0 ? _v[j] : _v[j] + (fraction * (_v[j + 1] - _v[j]));
                var line = new RegionLine(_surface.Region, alongU: true, v);
                for (var i = 0; i + 1 < longest.Length; i++)
                {
                    foreach (var part in Fractions)
                    {
                        var u = longest[i] + (part * (longest[i + 1] - longest[i]));
                        var error = line.IsInside(u) ? ErrorAt(u, v) : 0;
                        everywhere = Math.Max(everywhere, error);
                        onCurves = fraction == 0 ? Math.Max(onCurves, error) : onCurves;
                    }
                }
            }
        }

        return (onCurves, everywhere);
    }

    // Only within the points. Nothing is claimed beyond them.
    private double ErrorAt(double u, double v)
    {
        Span<double> across = stackalloc double[Support];
        Span<double> along = stackalloc double[Support];
        var first = Weights(_v, _isBreakV, v, ref across);
        var sum = Vector3.Zero;
        for (var k = 0; k < across.Length; k++)
        {
            var j = first + k;
            if (across[k] == 0)
            {
                continue;
            }

            if (u < _u[j][0] || u > _u[j][^1])
            {
                return 0;
            }

            var weights = along;
            var start = Weights(_u[j], _isBreakU[j], u, ref weights);
            for (var i = 0; i < weights.Length; i++)
            {
                var point = _points[j][start + i];
                sum += new Vector3(point.X, point.Y, point.Z) * (across[k] * weights[i]);
            }
        }

        var at = _surface.Spline.At(u, v);
        return Math.Abs((new Point3(sum.X, sum.Y, sum.Z) - at.Position).Dot(at.Normal));
    }

    // Lagrange weights of the nodes around a parameter, within its interval between breaks. Returns the index of the first node.
    private static int Weights(double[] nodes, bool[] isBreak, double t, ref Span<double> weights)
    {
        var i = Math.Clamp(Array.BinarySearch(nodes, t) is var found && found >= 0 ? found : ~found - 1, 0, nodes.Length - 2);
        var (low, high) = (i, i + 1);
        while (low > 0 && !isBreak[low])
        {
            low--;
        }

        while (high < nodes.Length - 1 && !isBreak[high])
        {
            high++;
        }

        var count = Math.Min(Support, high - low + 1);
        var first = Math.Clamp(i - 1, low, high - count + 1);
        weights = weights[..count];
        for (var a = 0; a < count; a++)
        {
            weights[a] = 1;
            for (var b = 0; b < count; b++)
            {
                weights[a] *= a == b ? 1 : (t - nodes[first + b]) / (nodes[first + a] - nodes[first + b]);
            }
        }

        return first;
    }
}
