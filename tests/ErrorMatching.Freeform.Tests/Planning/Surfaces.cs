using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Surfaces with closed forms, and jobs to measure them by.</summary>
internal static class Surfaces
{
    public const double Width = 75, Depth = 63;

    /// <summary>Identical quadratic profiles along u, straight along v, as Surface one of Lee 2019:
    /// x and y run with u and v, z = -x²/50 + x/2.</summary>
    public static PartSurface One { get; } = Quadratic((x, _) => (-x * x / 50) + (x / 2));

    /// <summary>Straight along u with slopes that differ, quadratic along v from convex to concave, as Surface two:
    /// z = (x/75 - 1/2) y(63 - y)/80.</summary>
    public static PartSurface Two { get; } = Quadratic((x, y) => ((x / Width) - 0.5) * y * (Depth - y) / 80);

    /// <summary>Quadratic both ways, from convex to concave, as Surface three.</summary>
    public static PartSurface Three { get; } = Quadratic(
        (x, y) => ((y / Depth) - 0.5) * x * (Width - x) / 90 + (((x / Width) - 0.5) * y * (Depth - y) / 120));

    public static PartSurface Flat { get; } = Quadratic((_, _) => 0);

    /// <summary>A surface over the paper's rectangle whose height is quadratic at most in each coordinate:
    /// poles by blossoming three values.</summary>
    public static PartSurface Quadratic(Func<double, double, double> height)
    {
        double[] t = [0, 0.5, 1];
        var values = new double[3, 3];
        for (var i = 0; i < 3; i++)
        {
            for (var j = 0; j < 3; j++)
            {
                values[i, j] = height(t[i] * Width, t[j] * Depth);
            }
        }

        // The middle pole of a quadratic with values a, m, b at 0, 1/2, 1 is 2m - (a + b)/2.
        for (var i = 0; i < 3; i++)
        {
            values[i, 1] = (2 * values[i, 1]) - ((values[i, 0] + values[i, 2]) / 2);
        }

        for (var j = 0; j < 3; j++)
        {
            values[1, j] = (2 * values[1, j]) - ((values[0, j] + values[2, j]) / 2);
        }

        var knots = KnotVector.Clamped(2, [0, 1]);
        return new(
            "test",
            new SplineSurface(knots, knots, Poles(3, 3, (i, j) => new(t[i] * Width, t[j] * Depth, values[i, j]))),
            SurfaceRegion.Whole,
            1);
    }

    /// <summary>A surface straight along v whose profile along u is a spline with given knots: pole i lies at the mean of its knots (so
    /// that x runs with u) and at a height.</summary>
    public static PartSurface Profile(KnotVector knots, Func<double, double> height)
    {
        var across = KnotVector.Clamped(1, [0, 1]);
        return new(
            "test",
            new SplineSurface(
                knots,
                across,
                Poles(knots.PoleCount, 2, (i, j) => new(knots.Greville(i) * Width, j * Depth, height(knots.Greville(i) * Width)))),
            SurfaceRegion.Whole,
            1);
    }

    public static JobMeasuring Measuring(int curves, int? each = null, int? points = null) => new()
    {
        Curves = curves,
        PointsPerCurve = each,
        Points = points,
        StylusDiameterMm = 6,
        ApproachMm = 2,
        OvertravelMm = 2,
        ClearanceMm = 10,
        FeedMmPerMin = 100,
        Dialect = "siemens-840d",
        ReportsStylusCenter = false,
        After = CuttingStage.SemiFinishing,
        UncertaintyMm = 0.000125,
        BestFit = false,
    };

    private static Point3[] Poles(int countU, int countV, Func<int, int, Point3> pole)
    {
        var poles = new Point3[countU * countV];
        for (var k = 0; k < poles.Length; k++)
        {
            poles[k] = pole(k / countV, k % countV);
        }

        return poles;
    }
}
