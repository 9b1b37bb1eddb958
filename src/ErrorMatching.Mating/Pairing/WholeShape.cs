using ErrorMatching.Geometry;
using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Factorization;

namespace ErrorMatching.Mating;

/// <summary>The deviation of a feature that is estimated as a whole: its shift and growth, and with flanks its turn and stretch, by least
/// squares of the deviations at its key points.</summary>
/// <remarks>The standard deviation of a point is that of the residuals or the stated uncertainty, whichever is larger.</remarks>
internal sealed class WholeShape
{
    private readonly Point2 _middle;
    private readonly double _arm;
    private readonly Vector2? _along;
    private readonly Vector<double> _mean;

    // Its columns, times standard normal numbers, are what is not known about the parameters.
    private readonly Matrix<double> _spread;

    private WholeShape(Point2 middle, double arm, Vector2? along, IReadOnlyList<(Point2 Place, Vector2 Normal, double Mm)> points, double u)
    {
        (_middle, _arm, _along) = (middle, arm, along);
        var rows = Matrix<double>.Build.DenseOfRowArrays(points.Select(p => Row(p.Place, p.Normal)));
        var values = Vector<double>.Build.Dense(points.Count, i => points[i].Mm);
        var fitted = Fit(rows, u);
        var left = values - (rows * fitted.Solve(rows.TransposeThisAndMultiply(values) / (u * u)));
        var freedom = points.Count - rows.ColumnCount;
        var scatter = freedom > 0 ? Math.Sqrt(left.DotProduct(left) / freedom) : 0;
        u = Math.Max(u, scatter);
        fitted = Fit(rows, u);
        _mean = fitted.Solve(rows.TransposeThisAndMultiply(values) / (u * u));
        _spread = fitted.Factor.Transpose().Inverse();
    }

    /// <summary>The shape of key points.</summary>
    /// <param name="points">Their designed places, normals and deviations along them.</param>
    /// <param name="flanks">The straight cuts of the feature.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a point.</param>
    public static WholeShape Of(
        IReadOnlyList<(Point2 Place, Vector2 Normal, double Mm)> points, IReadOnlyList<Segment2> flanks, double uncertaintyMm)
    {
        var middle = new Point2(points.Average(p => p.Place.X), points.Average(p => p.Place.Y));
        var longest = flanks.Where(f => f.Length > 0).Select(f => (Segment2?)f).MaxBy(f => f!.Value.Length);
        return new(
            middle,
            Math.Max(points.Max(p => p.Place.DistanceTo(middle)), 1e-6),
            longest is { } flank ? (flank.End - flank.Start).Normalize() : null,
            points,
            Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm));
    }

    /// <summary>The expected deviation at a place, toward the tool, mm.</summary>
    public double DeviationAt(Point2 place, Vector2 normal) => Vector<double>.Build.Dense(Row(place, normal)).DotProduct(_mean);

    /// <summary>What is not known about the deviations at places together, in columns.</summary>
    public IReadOnlyList<double[]> Factor(IReadOnlyList<(Point2 Place, Vector2 Normal)> places)
    {
        var rows = Matrix<double>.Build.DenseOfRowArrays(places.Select(p => Row(p.Place, p.Normal)));
        return (rows * _spread).ToColumnArrays();
    }

    // What each parameter does at a place. The ends of a stretched slot shift apart.
    private double[] Row(Point2 place, Vector2 normal) => _along is not { } along
        ? [normal.X, normal.Y, 1]
        : [
            normal.X, normal.Y, 1, (place - _middle).Cross(normal) / _arm,
            Math.Sign((place - _middle).Dot(along)) * normal.Dot(along)];

    // What no point tells is vague.
    private static Cholesky<double> Fit(Matrix<double> rows, double u)
    {
        var precision = rows.TransposeThisAndMultiply(rows) / (u * u);
        for (var i = 0; i < precision.RowCount; i++)
        {
            precision[i, i] += 1 / (DeviationPrior.VagueMm * DeviationPrior.VagueMm);
        }

        return precision.Cholesky();
    }
}
