using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class ProbeAccessTests
{
    [Fact]
    public void A_hollow_tighter_than_the_ball_is_refused_by_the_names_of_its_points()
    {
        // z = (x - 37.5)²/4: the radius at the bottom is 2 mm, less than the ball's 3.
        var plan = MeasuringPlanner.Plan(Surfaces.Quadratic((x, _) => (x - 37.5) * (x - 37.5) / 4), Surfaces.Measuring(2, 5));
        var bottom = plan.Points.Where(p => p.I == 2).ToArray();
        Assert.All(
            bottom,
            p => Assert.Contains(
                plan.Refusals,
                r => r.Code == "untouchable-point"
                    && r.Message.StartsWith(FormattableString.Invariant($"point {p.Number} "), StringComparison.Ordinal)));
        Assert.Contains(plan.Refusals, r => r.Message.Contains("radius of 2 mm", StringComparison.Ordinal));
    }

    [Fact]
    public void A_hollow_wider_than_the_ball_is_touched()
    {
        // A parabola whose radius is 20 mm at the bottom and larger beside it.
        var plan = MeasuringPlanner.Plan(Surfaces.Quadratic((x, _) => (x - 37.5) * (x - 37.5) / 40), Surfaces.Measuring(3, 7), 0.2);
        Assert.Empty(plan.Refusals);
    }

    [Fact]
    public void A_surface_that_faces_down_is_refused()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Flat with { Outside = -1 }, Surfaces.Measuring(2, 2));
        Assert.Equal(4, plan.Refusals.Count);
        Assert.All(plan.Refusals, r => Assert.Contains("points down", r.Message, StringComparison.Ordinal));
    }

    [Fact]
    public void A_floor_beside_a_high_wall_is_touched_only_where_the_ball_has_room()
    {
        // A floor that goes over into a wall of 30 mm within 2 mm about x = 37.5.
        double[] breaks = [.. Enumerable.Range(0, 401).Select(i => i / 400.0)];
        var surface = Surfaces.Profile(KnotVector.Clamped(3, breaks), x => 30 / (1 + Math.Exp(-(x - 37.5) * 4)));
        var plan = MeasuringPlanner.Plan(surface, Surfaces.Measuring(2, 16));
        foreach (var point in plan.Points)
        {
            var refused = plan.Refusals.Any(r => r.Message.StartsWith(
                FormattableString.Invariant($"point {point.Number} "), StringComparison.Ordinal));
            if (point.Position.X < 37.5 - 5 || point.Position.X > 37.5 + 5)
            {
                Assert.False(refused, $"{point.Position.X}");
            }
            else if (point.Position.X is > 35.6 and < 36.8)
            {
                Assert.True(refused, $"{point.Position.X}");
            }
        }

        Assert.NotEmpty(plan.Refusals);
    }

    [Fact]
    public void A_wall_that_leans_away_is_touched_along_its_normal()
    {
        // 80 degrees steep.
        var plan = MeasuringPlanner.Plan(Surfaces.Quadratic((x, _) => x * Math.Tan(80 * Math.PI / 180)), Surfaces.Measuring(2, 4), 0.2);
        Assert.Empty(plan.Refusals);
        Assert.All(plan.Points, p => Assert.Equal(-Math.Sin(80 * Math.PI / 180), p.Normal.X, 1e-9));
    }

    [Fact]
    public void Travel_is_clear_of_the_highest_point_by_the_clearance()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.One, Surfaces.Measuring(7, 10), 0.2);

        // The top of the parabola is z = 3.125 at x = 12.5.
        Assert.Equal(3.125 + 0.2 + 10 + 3, plan.ClearanceZ, 1e-3);
    }
}
