using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Spreads points along a curve. It blends equal shares of the turning angle with equal shares of the length, so that straight
/// stretches get points too.</summary>
/// <remarks>Lee 2019, section 2.3: denser where the slope changes much between neighbors, sparser where it changes little.</remarks>
internal sealed class CurveSpacing
{
    /// <summary>The weight of the length; the rest is the angle.</summary>
    private const double LengthPart = 0.3;

    /// <summary>A curve that turns by less than this, in radians, is straight.</summary>
    private const double Straight = 1e-9;

    private const int Parts = 1000;
    private readonly double[] _t = new double[Parts + 1];
    private readonly double[] _share = new double[Parts + 1];

    private CurveSpacing(double start, double end)
    {
        for (var i = 0; i <= Parts; i++)
        {
            _t[i] = start + ((end - start) * i / Parts);
        }

        (_t[0], _t[^1]) = (start, end);
    }

    /// <summary>Turning angle of the curves between the ends, in radians.</summary>
    public double AngleRad { get; private set; }

    /// <summary>Length of the curves between the ends, in millimeters.</summary>
    public double LengthMm { get; private set; }

    /// <summary>Returns the mean spacing of curves between two parameters. Only parts in the region count, if any.</summary>
    public static CurveSpacing Find(IReadOnlyList<IsoCurve> curves, double start, double end)
    {
        var spacing = new CurveSpacing(start, end);
        foreach (var curve in curves)
        {
            spacing.Add(curve, 1.0 / curves.Count);
        }

        return spacing;
    }

    /// <summary>Returns the parameters of points, ascending.</summary>
    /// <param name="count">Number of points; at least two plus the breaks.</param>
    /// <param name="breaks">Places strictly between the ends that get their own point.</param>
    public IReadOnlyList<(double T, PlanReason Reason)> Place(int count, IReadOnlyList<double> breaks)
    {
        double[] nodes = [_t[0], .. breaks, _t[^1]];
        var shares = new double[nodes.Length - 1];
        for (var i = 0; i < shares.Length; i++)
        {
            shares[i] = ShareAt(nodes[i + 1]) - ShareAt(nodes[i]);
        }

        var between = LargestRemainder.Divide(count - nodes.Length, shares);
        var placed = new List<(double, PlanReason)>();
        for (var i = 0; i < nodes.Length; i++)
        {
            placed.Add((nodes[i], i == 0 || i == nodes.Length - 1 ? PlanReason.End : PlanReason.Break));
            for (var k = 1; i < shares.Length && k <= between[i]; k++)
            {
                var share = ShareAt(nodes[i]) + (shares[i] * k / (between[i] + 1));
                placed.Add((Math.Clamp(At(share), nodes[i], nodes[i + 1]), PlanReason.Slope));
            }
        }

        return placed;
    }

    private void Add(IsoCurve curve, double weight)
    {
        var (angles, lengths, angle, length) = (new double[Parts], new double[Parts], 0.0, 0.0);
        var (before, line) = (curve.At(_t[0]), curve.Line);
        for (var i = 0; i < Parts; i++)
        {
            var behind = curve.At(_t[i + 1]);
            if (line.IsInside((_t[i] + _t[i + 1]) / 2))
            {
                var (a, b) = (curve.Tangent(before), curve.Tangent(behind));
                angles[i] = Elementary.Atan2(a.Cross(b).Length, a.Dot(b));
                lengths[i] = (behind.Position - before.Position).Length;
                angle += angles[i];
                length += lengths[i];
            }

            before = behind;
        }

        AngleRad += weight * angle;
        LengthMm += weight * length;
        var (byAngle, byLength) = angle > Straight ? ((1 - LengthPart) / angle, LengthPart / length) : (0, 1 / length);
        for (var (i, sum) = (0, 0.0); i < Parts; i++)
        {
            sum += length > 0 ? (byAngle * angles[i]) + (byLength * lengths[i]) : 1.0 / Parts;
            _share[i + 1] += weight * sum;
        }
    }

    private double ShareAt(double t)
    {
        var i = Math.Clamp(Array.BinarySearch(_t, t) is var found && found >= 0 ? found : ~found - 1, 0, Parts - 1);
        return _share[i] + ((_share[i + 1] - _share[i]) * Math.Clamp((t - _t[i]) / (_t[i + 1] - _t[i]), 0, 1));
    }

    private double At(double share)
    {
        // The first part that reaches the share. The sum does not grow in a hole, so the edge before it is taken.
        var (low, high) = (0, Parts);
        while (low < high)
        {
            var middle = (low + high) / 2;
            (low, high) = _share[middle] < share ? (middle + 1, high) : (low, middle);
        }

        return low == 0 ? _t[0] : _t[low - 1] + ((_t[low] - _t[low - 1]) * ((share - _share[low - 1]) / (_share[low] - _share[low - 1])));
    }
}
