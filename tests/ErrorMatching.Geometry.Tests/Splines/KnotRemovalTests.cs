using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class KnotRemovalTests
{
    private static readonly Gen<(SplineCurve Curve, double A)> Cases = DrawSpline.Curve.Zip(Gen.Choose(-999, 999)).Select(
        p => (p.Item1, p.Item2 / 1000.0));

    [Fact]
    public void Removal_takes_an_inserted_knot_out_again() => Draw.Law(Cases, c =>
    {
        var t = DrawSpline.Inside(c.Curve.Knots, c.A);
        var before = c.Curve.Clamp();
        if (before.Knots.Multiplicity(t) > before.Knots.Degree - 1)
        {
            return true;
        }

        var (after, moved) = before.InsertKnot(t).RemoveKnot(t);
        return after.Knots.Equals(before.Knots) && moved < 1e-9 && Poles(after, before) < 1e-7;
    });

    [Fact]
    public void No_point_moves_farther_than_the_bound_says() => Draw.Law(Cases, c =>
    {
        var before = c.Curve.Clamp();
        var inner = before.Knots.Breaks.Skip(1).First();
        if (inner == before.Knots.End || before.Knots.Multiplicity(inner) > before.Knots.Degree)
        {
            return true;
        }

        SplineCurve after;
        double bound;
        try
        {
            (after, bound) = before.RemoveKnot(inner);
        }
        catch (GeometryException e) when (before.IsRational && e.Error == GeometryError.BadPoles)
        {
            return true;
        }

        var worst = Enumerable.Range(0, 101).Max(
            i => (
                before.PointAt(DrawSpline.Inside(before.Knots, (i / 50.0) - 1))
                    - after.PointAt(DrawSpline.Inside(before.Knots, (i / 50.0) - 1))).Length);
        return worst <= bound + 1e-9
            && (after.Poles[0] - before.Poles[0]).Length < 1e-9
            && (after.Poles[^1] - before.Poles[^1]).Length < 1e-9;
    });

    [Fact]
    public void No_other_poles_are_nearer_to_the_old_ones() =>
        Draw.Law(Cases.Where(c => !c.Curve.IsRational && c.Curve.Knots.Degree > 1).Zip(Gen.Choose(0, 1_000_000)), c =>
    {
        var before = c.Item1.Curve.Clamp();
        var inner = before.Knots.Breaks.Skip(1).First();
        if (inner == before.Knots.End || before.Knots.Multiplicity(inner) >= before.Knots.Degree)
        {
            return true;
        }

        // The most displaced pole of any other curve with the same ends over the fewer knots is displaced as far.
        var (best, bound) = before.RemoveKnot(inner);
        var noise = Draw.Noise(c.Item2, 3 * best.Poles.Length);
        Point3[] poles = [.. best.Poles];
        for (var i = 1; i < poles.Length - 1; i++)
        {
            poles[i] += new Vector3(noise[3 * i], noise[(3 * i) + 1], noise[(3 * i) + 2]) * (0.1 * bound);
        }

        return Poles(new SplineCurve(best.Knots, poles).WithKnots(before.Knots), before) >= bound - 1e-9;
    });

    [Fact]
    public void Knot_that_bends_a_polyline_moves_it_by_its_height_over_the_chord()
    {
        // Degree 1: the only freedom is the middle pole, and without its knot it lies on the chord.
        var polyline = new SplineCurve(KnotVector.Clamped(1, [0, 1, 2]), [new(0, 0, 0), new(5, 3, 0), new(10, 0, 0)]);
        var (line, moved) = polyline.RemoveKnot(1);
        Assert.Equal(2, line.Poles.Length);
        Assert.Equal(3, moved, 1e-14);
    }

    [Fact]
    public void Knot_of_a_surface_comes_out_again_in_both_directions() => Draw.Law(
        DrawSpline.Surface.Where(s => s.KnotsU.Degree > 1 && s.KnotsV.Degree > 1).Zip(Gen.Choose(-999, 999)),
        c =>
        {
            var before = c.Item1.Clamp();
            var (u, v) = (DrawSpline.Inside(before.KnotsU, c.Item2 / 1000.0), DrawSpline.Inside(before.KnotsV, -c.Item2 / 1000.0));
            if (before.KnotsU.Multiplicity(u) > 0 || before.KnotsV.Multiplicity(v) > 0)
            {
                return true;
            }

            var (less, movedU) = before.InsertKnotU(u).InsertKnotV(v).RemoveKnotU(u);
            var (after, movedV) = less.RemoveKnotV(v);
            var worst = 0.0;
            for (var i = 0; i < before.Poles.Length; i++)
            {
                worst = Math.Max(worst, (before.Poles[i] - after.Poles[i]).Length);
            }

            return after.KnotsU.Equals(before.KnotsU)
                && after.KnotsV.Equals(before.KnotsV)
                && movedU < 1e-9
                && movedV < 1e-9
                && worst < 1e-7;
        },
        200);

    [Fact]
    public void What_is_no_inner_knot_is_refused()
    {
        var curve = new SplineCurve(KnotVector.Clamped(2, [0, 1, 2]), [new(0, 0, 0), new(1, 0, 0), new(2, 1, 0), new(3, 0, 0)]);
        Refused.With(GeometryError.BadKnots, () => curve.RemoveKnot(0));
        Refused.With(GeometryError.BadKnots, () => curve.RemoveKnot(0.5));
    }

    private static double Poles(SplineCurve a, SplineCurve b)
    {
        var worst = 0.0;
        for (var i = 0; i < a.Poles.Length; i++)
        {
            worst = Math.Max(worst, (a.Poles[i] - b.Poles[i]).Length);
        }

        return worst;
    }
}
