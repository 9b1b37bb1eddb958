using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class SplineCurveChangesTests
{
    private const double Rounding = 1e-10;

    private static readonly Gen<(SplineCurve Curve, double A, double B)> Cases =
        DrawSpline.Curve.Zip(Gen.Choose(-999, 999).Two()).Select(p => (p.Item1, p.Item2.Item1 / 1000.0, p.Item2.Item2 / 1000.0));

    [Fact]
    public void Inserted_knots_do_not_move_the_curve() => Draw.Law(Cases, c =>
    {
        var t = DrawSpline.Inside(c.Curve.Knots, c.A);
        var finer = c.Curve.InsertKnot(t).InsertKnot(DrawSpline.Inside(c.Curve.Knots, c.B));
        return finer.Knots.Multiplicity(t) >= 1 && Apart(c.Curve, finer, x => x) < Rounding;
    });

    [Fact]
    public void Bezier_curve_split_in_the_middle_has_the_poles_of_de_Casteljau()
    {
        var bezier = new SplineCurve(new(2, [0, 0, 0, 1, 1, 1]), [new(0, 0, 0), new(4, 8, 0), new(8, 0, 4)]);
        var (before, after) = bezier.Split(0.5);
        Assert.Equal([new(0, 0, 0), new(2, 4, 0), new(4, 4, 1)], before.Poles.ToArray());
        Assert.Equal([new(4, 4, 1), new(6, 4, 2), new(8, 0, 4)], after.Poles.ToArray());
    }

    [Fact]
    public void Line_raised_to_degree_3_has_poles_at_thirds()
    {
        var line = new SplineCurve(new(1, [0, 0, 1, 1]), [new(0, 0, 0), new(3, 6, 9)]);
        var cubic = line.ElevateTo(3);
        Assert.Equal(3, cubic.Knots.Degree);
        for (var i = 0; i < 4; i++)
        {
            Assert.True((cubic.Poles[i] - new Point3(i, 2 * i, 3 * i)).Length < 1e-14);
        }
    }

    [Fact]
    public void A_higher_degree_does_not_move_the_curve() => Draw.Law(Cases, c =>
    {
        var raised = c.Curve.ElevateTo(c.Curve.Knots.Degree + 3);
        return raised.Knots.Degree == c.Curve.Knots.Degree + 3 && Apart(c.Curve, raised, x => x) < Rounding;
    });

    [Fact]
    public void Parts_lie_on_the_whole_and_meet() => Draw.Law(Cases, c =>
    {
        var t = DrawSpline.Inside(c.Curve.Knots, c.A);
        var (before, after) = c.Curve.Split(t);
        return Apart(before, c.Curve, x => x) < Rounding && Apart(after, c.Curve, x => x) < Rounding
            && (before.Poles[^1] - after.Poles[0]).Length < Rounding && before.Knots.End == t && after.Knots.Start == t;
    });

    [Fact]
    public void Pieces_are_Bezier_curves_on_the_whole() => Draw.Law(Cases, c =>
    {
        var pieces = c.Curve.Pieces();
        return pieces.Count == c.Curve.Knots.Breaks.Count - 1
            && pieces.All(p => p.Poles.Length == p.Knots.Degree + 1 && Apart(p, c.Curve, x => x) < Rounding);
    });

    [Fact]
    public void Backwards_is_the_same_curve_from_its_end() => Draw.Law(Cases, c =>
    {
        var (start, end) = (c.Curve.Knots.Start, c.Curve.Knots.End);
        return Apart(c.Curve, c.Curve.Reverse(), x => start + (end - x)) < Rounding;
    });

    [Fact]
    public void Clamping_does_not_move_the_curve() => Draw.Law(Cases, c =>
    {
        var clamped = c.Curve.Clamp();
        return clamped.Knots.IsClamped && Apart(c.Curve, clamped, x => x) < Rounding
            && (clamped.Poles[0] - c.Curve.PointAt(c.Curve.Knots.Start)).Length < Rounding;
    });

    [Fact]
    public void Another_range_of_parameters_does_not_move_the_curve() => Draw.Law(Cases, c =>
    {
        var knots = c.Curve.Knots;
        var other = c.Curve.Reparametrize(-3, 40);
        return other.Knots.Start == -3
            && other.Knots.End == 40
            && Apart(c.Curve, other, x => -3 + (43 * (x - knots.Start) / (knots.End - knots.Start))) < 1e-8;
    });

    [Fact]
    public void Compatible_curves_have_the_same_knots_and_do_not_move() => Draw.Law(DrawSpline.Curve.Three(), c =>
    {
        SplineCurve[] curves = [c.Item1, c.Item2, c.Item3];
        var common = SplineCurve.Compatible(curves);
        var first = c.Item1.Knots;
        return common.All(k => k.Knots.Equals(common[0].Knots))
            && common[0].Knots.Degree == curves.Max(k => k.Knots.Degree)
            && (common[0].Knots.Start, common[0].Knots.End) == (first.Start, first.End)
            && curves.Zip(common).All(
                p => Apart(
                    p.First,
                    p.Second,
                    x => first.Start + ((first.End - first.Start) * (x - p.First.Knots.Start) / (p.First.Knots.End - p.First.Knots.Start)))
                    < 1e-7);
    });

    [Fact]
    public void Knots_apart_by_rounding_fall_together()
    {
        var third = new SplineCurve(
            KnotVector.Clamped(3, [0, 1.0 / 3, 1]), [new(0, 0, 0), new(1, 1, 0), new(2, 1, 0), new(3, 1, 0), new(4, 0, 0)]);
        var almost = new SplineCurve(KnotVector.Clamped(3, [0, Math.BitIncrement(1.0 / 3), 1]), third.Poles);
        Assert.NotEqual(third.Knots, almost.Knots);
        var common = SplineCurve.Compatible([third, almost]);
        Assert.Equal(third.Knots, common[1].Knots);
    }

    [Fact]
    public void Knots_outside_or_too_often_are_refused()
    {
        var curve = new SplineCurve(KnotVector.Clamped(2, [0, 1, 2]), [new(0, 0, 0), new(1, 0, 0), new(2, 1, 0), new(3, 0, 0)]);
        Refused.With(GeometryError.BadKnots, () => curve.InsertKnot(2));
        Refused.With(GeometryError.BadKnots, () => curve.InsertKnot(1, 3));
        Refused.With(GeometryError.BadKnots, () => curve.InsertKnot(double.NaN));
        Refused.With(GeometryError.BadKnots, () => curve.Between(1, 1));
        Refused.With(GeometryError.BadKnots, () => curve.Between(0, 2.5));
        Refused.With(GeometryError.BadKnots, () => curve.ElevateTo(1));
        Refused.With(GeometryError.BadKnots, () => curve.ElevateTo(KnotVector.MaxDegree + 1));
        Refused.With(GeometryError.BadKnots, () => curve.WithKnots(KnotVector.Clamped(2, [0, 0.5, 2])));
        Refused.With(GeometryError.BadKnots, () => KnotVector.Common([]));
    }

    private static double Apart(SplineCurve a, SplineCurve b, Func<double, double> parameter)
    {
        var worst = 0.0;
        for (var i = 0; i <= 40; i++)
        {
            // Never at a knot, where a curve may jump.
            var t = DrawSpline.Inside(a.Knots, ((i + 0.31) / 20.5) - 1);
            worst = Math.Max(worst, (a.PointAt(t) - b.PointAt(parameter(t))).Length);
        }

        return worst;
    }
}
