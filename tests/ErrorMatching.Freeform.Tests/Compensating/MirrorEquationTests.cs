using ErrorMatching.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Freeform.Tests;

public sealed class MirrorEquationTests
{
    [Fact]
    public void Too_much_material_becomes_as_much_too_little()
    {
        // Stock 0.2, and 0.015 more than that stands on a horizontal surface: the mirror surface is at 0.1, the measured point 0.115 over
        // it, so the compensation point is 0.115 below it.
        Vector3 up = new(0, 0, 1);
        var mirror = MirrorEquations.MirrorPoint(new(10, 20, 30), up, 0.2);

        Assert.Equal(30.1, mirror.Z, 12);
        Assert.Equal(29.985, MirrorEquations.CompensationPoint(new(10, 20, 30.215), mirror, up).Z, 12);
    }

    [Fact]
    public void Both_equations_come_to_the_ideal_point_less_the_error()
    {
        var cases =
            from x in Gen.Choose(-900, 900)
            from y in Gen.Choose(-900, 900)
            from z in Gen.Choose(1, 900)
            from e in Gen.Choose(-100, 100)
            from stock in Gen.Choose(0, 400)
            select (x, y, z, e, stock);
        Check.QuickThrowOnFailure(Prop.ForAll(cases.ToArbitrary(), c =>
        {
            Point3 ideal = new(c.x / 7.0, c.y / 9.0, c.z / 11.0);
            var normal = new Vector3(c.y, c.x, c.z).Normalize();
            var (error, stock) = (c.e / 1000.0, c.stock / 1000.0);
            var measured = ideal + (normal * (stock + error));
            var literal = MirrorEquations.CompensationPoint(measured, MirrorEquations.MirrorPoint(ideal, normal, stock), normal);
            return (literal - MirrorEquations.Compensated(ideal, normal, error, 1)).Length < 1e-12;
        }));
    }
}
