using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Factorization;

namespace ErrorMatching.Mating;

/// <summary>The deviation of a feature that is estimated as a whole: its shift and growth, and with flanks its turn and stretch, by least
/// squares of the deviations at its key points.</summary>
/// <remarks>The standard deviation of a point is that of the residuals or the stated uncertainty, whichever is larger.</remarks>
internal sealed record WholeShape
{
    // The boundary is compared at so many places all around.
    private const int AroundPlaces = 72;

    // A form error is taken for waves of two to four periods around it: oval, three and four lobes.
    private const int FormWaves = 3;

    // So many points more than the parameters show that a circle is oval.
    private const int TellingPoints = 3;

    private readonly Point2 _middle;
    private readonly double _arm;
    private readonly Vector2? _along;
    private readonly Vector<double> _mean;

    // Its columns, times standard normal numbers, are what is not known about the parameters.
    private readonly Matrix<double> _spread;

    // Of a point: the stated uncertainty, and what the points scatter.
    private readonly double _statedMm, _scatterMm;

    private readonly double _radius, _formMm;
    private readonly int _freedom;
    private readonly IReadOnlyList<Point2> _points;

    private WholeShape(
        Point2 middle,
        double arm,
        Vector2? along,
        IReadOnlyList<(Point2 Place, Vector2 Normal, double Mm)> points,
        double u,
        double radius)
    {
        (_middle, _arm, _along, _radius) = (middle, arm, along, radius);
        var rows = Matrix<double>.Build.DenseOfRowArrays(points.Select(p => Row(p.Place, p.Normal)));
        var values = Vector<double>.Build.Dense(points.Count, i => points[i].Mm);
        var fitted = Fit(rows, u);
        var left = values - (rows * fitted.Solve(rows.TransposeThisAndMultiply(values) / (u * u)));
        _freedom = points.Count - rows.ColumnCount;
        (_statedMm, _scatterMm) = (u, _freedom > 0 ? Math.Sqrt(left.DotProduct(left) / _freedom) : 0);
        _points = [.. points.Select(p => p.Place)];
        _formMm = FormOf(_scatterMm);
        u = Math.Max(u, _scatterMm);
        fitted = Fit(rows, u);
        _mean = fitted.Solve(rows.TransposeThisAndMultiply(values) / (u * u));
        _spread = fitted.Factor.Transpose().Inverse();
    }

    /// <summary>The shape of key points.</summary>
    /// <param name="points">Their designed places, normals and deviations along them.</param>
    /// <param name="flanks">The straight cuts of the feature.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a point.</param>
    /// <param name="radius">Distance of the path from the boundary, mm.</param>
    public static WholeShape Estimate(
        IReadOnlyList<(Point2 Place, Vector2 Normal, double Mm)> points,
        IReadOnlyList<Segment2> flanks,
        double uncertaintyMm,
        double radius = 0)
    {
        var middle = new Point2(points.Average(p => p.Place.X), points.Average(p => p.Place.Y));
        var longest = flanks.Where(f => f.Length > 0).Select(f => (Segment2?)f).MaxBy(f => f!.Value.Length);
        return new(
            middle,
            Math.Max(points.Max(p => p.Place.DistanceTo(middle)), 1e-6),
            longest is { } flank ? (flank.End - flank.Start).Normalize() : null,
            points,
            Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm),
            radius);
    }

    /// <summary>The shape of the feature that a run without elements cuts, against what the program before cuts there.</summary>
    /// <param name="run">The run, with the key points of the feature.</param>
    /// <param name="path">The program before.</param>
    /// <param name="pass">The cut of the feature.</param>
    public static WholeShape Around(RunEstimate run, NcPath path, FeaturePass pass)
    {
        var whole = new BoundaryElement(pass, pass.First, pass.Last, ElementForm.Free);
        return Estimate(
            [.. run.Points.Select(p => (p.Theoretical, p.Normal, p.FromTheoretical.Dot(p.Normal) - p.BaseMm))],
            [.. FeaturePass.Moving(path, pass.First, pass.Last).Select(i => path.Motions[i]).Where(m => !m.IsArc).Select(m => m.Segment)],
            run.UncertaintyMm,
            run.Run.Radius) with
        {
            Places = [
                .. Enumerable.Range(0, AroundPlaces).Select(k => run.Run.PlaceAt(whole, whole.ToMm * (k + 0.5) / AroundPlaces))],
        };
    }

    /// <summary>Places all around as the program before cuts them, with their normals toward the tool.</summary>
    public IReadOnlyList<(Point2 Place, Vector2 Normal)> Places { get; init; } = [];

    private bool TellsForm => _freedom >= TellingPoints;
    /// <summary>The worst error all around.</summary>
    /// <param name="before">The cuts of the program before.</param>
    /// <param name="after">Those of the program to cut.</param>
    /// <param name="statedMm">Standard deviation of the form error as the job states it; null if the points are to tell it.</param>
    /// <param name="limits">The limits of the error; null for none.</param>
    /// <param name="risk">The risk that an error anywhere around is larger than the interval of the worst one reaches.</param>
    /// <returns>The error; if the points do not tell a form error, that at the place furthest from all points, not known.</returns>
    public PredictedError WorstOn(RunPath before, RunPath after, double? statedMm, ToleranceBand? limits, double risk)
    {
        if (!Knows(statedMm))
        {
            return Error(Places.MaxBy(p => _points.Min(q => q.DistanceTo(p.Place)))) with
            {
                IsKnown = false
            };
        }

        PredictedError[] errors = [.. Places.Select(Error)];
        var worst = PredictedError.Worst(errors, limits)!;
        return worst.Within(BoundMm([.. errors.Select(e => e.AfterMm)], statedMm, risk));

        PredictedError Error((Point2 Place, Vector2 Normal) at)
        {
            var (shape, form) = (Factor([at]).Sum(c => c[0] * c[0]), statedMm ?? _formMm);
            return new(at.Place, at.Normal, ErrorOn(before, at), ErrorOn(after, at), Math.Sqrt(shape + (form * form)));
        }
    }

    /// <summary>True if something is known of the form error.</summary>
    /// <param name="statedMm">Standard deviation of the form error as the job states it; null if the points are to tell it.</param>
    public bool Knows(double? statedMm) => statedMm is not null || TellsForm;

    /// <summary>The value that the largest error at <see cref="Places"/> exceeds with a given risk.</summary>
    /// <remarks>What the points scatter is known no better than their number allows. Where the job states no form error, one is what the
    /// scatter has beyond the stated uncertainty in each draw: with a single estimate of it, the true error of circles whose form is about
    /// as large as the uncertainty was beyond the bound in one of five.</remarks>
    /// <param name="expectedMm">The expected errors there.</param>
    /// <param name="statedMm">Standard deviation of the form error as the job states it; null if the points are to tell it.</param>
    /// <param name="risk">The risk, above 0 and below 1.</param>
    public double BoundMm(IReadOnlyList<double> expectedMm, double? statedMm, double risk)
    {
        if (statedMm is not null)
        {
            return LargestError.BoundMm(expectedMm, FactorAround(statedMm), null, risk);
        }

        var shape = Factor(Places);
        var scale = new ColumnScale(
            _freedom,
            (column, ratio) => column < shape.Count
                ? Math.Max(_statedMm, ratio * _scatterMm) / Math.Max(_statedMm, _scatterMm)
                : FormOf(ratio * _scatterMm));
        return LargestError.BoundMm(expectedMm, [.. shape, .. FormAround(1)], scale, risk);
    }

    private double FormOf(double scatterMm) => Math.Sqrt(Math.Max(0, (scatterMm * scatterMm) - (_statedMm * _statedMm)));

    private double ErrorOn(RunPath cuts, (Point2 Place, Vector2 Normal) at) =>
        cuts.FootOf(at.Place + (at.Normal * DeviationAt(at.Place, at.Normal)), at.Normal).DistanceMm - _radius;

    /// <summary>The expected deviation at a place, toward the tool, mm.</summary>
    public double DeviationAt(Point2 place, Vector2 normal) => Vector<double>.Build.Dense(Row(place, normal)).DotProduct(_mean);

    /// <summary>What is not known about the deviations at places together, in columns.</summary>
    public IReadOnlyList<double[]> Factor(IReadOnlyList<(Point2 Place, Vector2 Normal)> places)
    {
        var rows = Matrix<double>.Build.DenseOfRowArrays(places.Select(p => Row(p.Place, p.Normal)));
        return (rows * _spread).ToColumnArrays();
    }

    /// <summary>What is not known about the deviations at <see cref="Places"/> together, the form error included, in columns.</summary>
    /// <param name="statedMm">Standard deviation of the form error as the job states it; null for what the points tell of it.</param>
    public IReadOnlyList<double[]> FactorAround(double? statedMm) =>
        [.. Factor(Places), .. FormAround(statedMm ?? (TellsForm ? _formMm : 0))];

    private IEnumerable<double[]> FormAround(double mm) => Enumerable.Range(2, FormWaves).SelectMany(n =>
        new[] { 0.0, Math.PI / 2 }.Select(phase =>
            Places.Select((_, k) => mm / Math.Sqrt(FormWaves) * Elementary.Cos((2 * Math.PI * n * k / Places.Count) - phase)).ToArray()));

    // What each parameter does at a place. The ends of a stretched slot shift apart.
    private double[] Row(Point2 place, Vector2 normal) => _along is not { } along
        ? [normal.X, normal.Y, 1]
        : [
            normal.X, normal.Y, 1, (place - _middle).Cross(normal) / _arm,
            Math.Sign((place - _middle).Dot(along)) * normal.Dot(along)];

    // What no point tells is vague. A few rows, in the library of the products around it.
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
