using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Whether a file was measured on a grid of its own: its points lie on the surface, but not where a plan has points, or under
/// other numbers.</summary>
internal static class OwnGrid
{
    // Enough to tell, and little work for any file.
    private const int Looked = 200;

    /// <summary>What is wrong with a whole file, as the end of a sentence; null if its points do not tell.</summary>
    /// <param name="points">Its points.</param>
    /// <param name="plan">The plan.</param>
    /// <param name="limitMm">The largest distance from an expected place.</param>
    public static string? Of(IReadOnlyList<RawPoint> points, MeasuringPlan plan, double limitMm)
    {
        var every = Math.Max(1, points.Count / Looked);
        var (looked, onSurface, elsewhere, otherwise) = (0, 0, 0, 0);
        for (var i = 0; i < points.Count; i += every)
        {
            looked++;
            var point = points[i];
            var radius = point.IsCenter ? plan.StylusRadiusMm : 0;
            var nearest = plan.Points.MinBy(p => (Expected(p, radius) - point.Position).Length)!;
            if (NormalFoot.Find(plan.Surface.Spline, point.Position, nearest.U, nearest.V) is not { } foot
                || Math.Abs((point.Position - foot.Position).Length - radius) >= limitMm)
            {
                continue;
            }

            onSurface++;
            var off = Expected(nearest, radius) - point.Position;
            // Along the surface: how far it is above or below says nothing about the place.
            elsewhere += (off - (nearest.Normal * off.Dot(nearest.Normal))).Length >= limitMm ? 1 : 0;
            otherwise += (point.Number ?? nearest.Number) != nearest.Number
                || (point.Number is null && (point.I != nearest.I || point.J != nearest.J)) ? 1 : 0;
        }

        // A point of another grid can happen to lie near one of the plan.
        return onSurface < looked || looked < 2 ? null
            : 4 * elsewhere > looked ? "but not where the plan has points: the file was measured on a grid of its own"
            : 2 * otherwise > looked ? "but under other numbers than in the plan: the file numbers them in an order of its own"
            : null;

        Point3 Expected(PlanPoint planned, double radius) => plan.ContactOf(planned) + (planned.Normal * radius);
    }
}
