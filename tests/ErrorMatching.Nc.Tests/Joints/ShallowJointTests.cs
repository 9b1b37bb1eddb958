using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Elements that meet at small angles, to both sides, straight and round, on grids of 0.001 to 0.00001 mm: expected joints are
/// intersections in closed form.
/// </summary>
public sealed class ShallowJointTests
{
    private static readonly double[] Radii = [0, 0.5, -0.5, 9.1, -60];

    public static TheoryData<double> Angles => [0.1, 0.5, 1, 2, 5, 5.7, 5.8, 10];

    [Fact]
    public void A_line_that_meets_an_arc_is_displaced_to_both_sides()
    {
        // The line x = 29.369 meets a circle about (29.716, -2.784); to the left the line goes to +X, the circle shrinks.
        var path = WrongProgram.Read("line-meets-arc.ngc", "linuxcnc");
        var radius = new Vector2(0.347, 9.098).Length;
        foreach (var left in (double[])[0.02, -0.02])
        {
            var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N3", "N4"), left));
            var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path.Dialect);
            var (corner, aside) = (Bench.MotionOf(now, "N3").PlaneEnd, 0.347 - left);
            Assert.Equal(29.369 + left, corner.X, 1e-9);
            Assert.Equal(-2.784 + Math.Sqrt(((radius - left) * (radius - left)) - (aside * aside)), corner.Y, 0.00006);
            Assert.Equal(0, Bench.MotionOf(now, "N4").Center.DistanceTo(new(29.716, -2.784)), 0.0003);
        }
    }

    [Theory]
    [MemberData(nameof(Angles))]
    public void Offsets_meet_where_lines_and_circles_do(double degrees)
    {
        foreach (var (before, behind) in Radii.SelectMany(a => Radii.Select(b => (a, b))))
        {
            foreach (var (turn, decimals) in ((double, int)[])[(degrees, 3), (-degrees, 3), (degrees, 4), (-degrees, 4), (degrees, 5)])
            {
                var joint = new ShallowJoint(before, behind, turn, decimals);
                foreach (var left in (double[])[0.02, -0.02, 0.3, -0.3])
                {
                    try
                    {
                        Check(joint, left);
                    }
                    catch (Exception e)
                    {
                        throw new InvalidOperationException($"Radii {before}, {behind}, turn {turn}, left {left}:\n{joint.Text}", e);
                    }
                }
            }
        }
    }

    // One of the two stays where it is: the other slides along it, or the joint takes the displacement.
    [Theory]
    [MemberData(nameof(Angles))]
    public void One_element_alone_is_proved(double degrees)
    {
        foreach (var (before, behind) in Radii.SelectMany(a => Radii.Select(b => (a, b))))
        {
            var path = Bench.Read(new ShallowJoint(before, behind, degrees, 4).Text);
            foreach (var (named, left) in ((string, double)[])[("N10", 0.02), ("N10", -0.02), ("N20", 0.02), ("N20", -0.02)])
            {
                Bench.Rewritten(path, DisplacementWish.Normal(path, Bench.Blocks(path, named), left).Result!);
            }
        }
    }

    private static void Check(ShallowJoint joint, double left)
    {
        var path = Bench.Read(joint.Text);
        var rewrite = Bench.Rewritten(path, DisplacementWish.Normal(path, Bench.Blocks(path, "N10..N20"), left).Result!);
        var now = NcInterpreter.Run(rewrite.Program, path.Dialect);
        var (a, b, place) = (Bench.MotionOf(path, "N10"), Bench.MotionOf(path, "N20"), Bench.MotionOf(now, "N10").PlaneEnd);
        var (rounding, missA, missB) = (1.1 * rewrite.LeastIncrementMm, Mismatch(a), Mismatch(b));

        // An arc whose ends were rounded misses its own circle by so much; at a corner, that shifts the crossing of the two.
        var sine = Math.Abs(a.TangentAt(1).Cross(b.TangentAt(0)));
        Assert.InRange(ShallowJoint.Off(a, a.PlaneEnd, place, left), 0, rounding + missA);
        Assert.InRange(ShallowJoint.Off(b, a.PlaneEnd, place, left), 0, rounding + missB);
        Assert.InRange(place.DistanceTo(ShallowJoint.Closed(a, b, left)), 0, rounding + (sine > 0.1 ? 1.5 * (missA + missB) / sine : 0));
    }

    private static double Mismatch(NcMotion m) =>
        m.IsArc ? Math.Abs(m.PlaneStart.DistanceTo(m.Center) - m.PlaneEnd.DistanceTo(m.Center)) : 0;
}
