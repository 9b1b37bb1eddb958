using System.Globalization;

namespace ErrorMatching.Geometry;

/// <content>The fitting.</content>
public sealed partial class PolynomialFit
{
    /// <summary>Fits a polynomial to points given as doubles.</summary>
    /// <param name="x">Abscissae.</param>
    /// <param name="y">Ordinates, in the same number.</param>
    /// <param name="options">Degree, ridge and stated uncertainty; null selects the degree and does not regularize.</param>
    /// <exception cref="GeometryException">As for the overload with double-doubles.</exception>
    /// <exception cref="ArgumentException">Abscissae and ordinates differ in number.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A degree, ridge weight or uncertainty is negative or not finite.</exception>
    public static PolynomialFit Fit(IReadOnlyList<double> x, IReadOnlyList<double> y, PolynomialFitOptions? options = null) =>
        Fit([.. x.Select(v => (DoubleDouble)v)], [.. y.Select(v => (DoubleDouble)v)], options);

    /// <summary>Fits a polynomial to points whose decimals are kept in double-double.</summary>
    /// <param name="x">Abscissae in any order; repetitions are allowed.</param>
    /// <param name="y">Ordinates, in the same number.</param>
    /// <param name="options">Degree, ridge and stated uncertainty; null selects the degree and does not regularize.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/> if there are fewer points than coefficients (or none);
    /// <see cref="GeometryError.CoincidentPoints"/> if all points coincide and more than a constant is requested;
    /// <see cref="GeometryError.RankDeficient"/> if there are fewer distinct abscissae than coefficients;
    /// <see cref="GeometryError.NotFinite"/>.</exception>
    /// <exception cref="ArgumentException">Abscissae and ordinates differ in number.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A degree, ridge weight or uncertainty is negative or not finite.</exception>
    public static PolynomialFit Fit(IReadOnlyList<DoubleDouble> x, IReadOnlyList<DoubleDouble> y, PolynomialFitOptions? options = null)
    {
        options ??= new();
        Check(options);
        Check(x, y, (options.Degree ?? 0) + 1);

        // Sorted, so that sums do not depend on the order of the points.
        int[] places = [.. Enumerable.Range(0, x.Count).OrderBy(i => x[i]).ThenBy(i => y[i])];
        DoubleDouble[] sortedX = [.. places.Select(i => x[i])];
        DoubleDouble[] sortedY = [.. places.Select(i => y[i])];
        var distinct = 1 + Enumerable.Range(1, sortedX.Length - 1).Count(i => sortedX[i] != sortedX[i - 1]);
        if (options.Degree >= distinct)
        {
            throw TooFewPlaces(options.Degree.Value, distinct, sortedY[0] == sortedY[^1] && distinct == 1);
        }

        var lowest = options.Degree ?? 0;
        var highest = options.Degree ?? Math.Min(options.MaxDegree, distinct - 1);
        var basis = ForsytheBasis.Build(sortedX, sortedY, highest);
        var leaveOneOut = new LeaveOneOut(basis);
        var (degree, ridge) = (options.Degree, options.Ridge) switch
        {
            ({ } fixedDegree, { } fixedRidge) => (fixedDegree, fixedRidge),
            (null, { } fixedRidge) => (
                DegreeChoice.Select(sortedX, sortedY, basis, fixedRidge, options.PointUncertaintyMm), fixedRidge),
            _ => leaveOneOut.Choose(
                Enumerable.Range(lowest, highest - lowest + 1), LeaveOneOut.Grid(), sortedY.Max(v => Math.Abs(v.ToDouble()))),
        };
        return new(basis, leaveOneOut, degree, ridge, places, options.PointUncertaintyMm);
    }

    private static void Check(PolynomialFitOptions options)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(options.Degree ?? 0, nameof(options));
        ArgumentOutOfRangeException.ThrowIfNegative(options.MaxDegree, nameof(options));
        if (options.Ridge is { } ridge && !(ridge >= 0 && double.IsFinite(ridge)))
        {
            throw new ArgumentOutOfRangeException(nameof(options), ridge, "A ridge weight is zero or more.");
        }

        Samples.CheckUncertainty(options.PointUncertaintyMm);
    }

    private static void Check(IReadOnlyList<DoubleDouble> x, IReadOnlyList<DoubleDouble> y, int least)
    {
        if (x.Count != y.Count)
        {
            throw new ArgumentException(
                string.Create(CultureInfo.InvariantCulture, $"{x.Count} abscissae cannot go with {y.Count} ordinates."), nameof(y));
        }

        if (x.Count < least)
        {
            throw new GeometryException(
                GeometryError.TooFewPoints,
                string.Create(
                    CultureInfo.InvariantCulture, $"A polynomial of degree {least - 1} needs at least {least} points; {x.Count} given."));
        }

        for (var i = 0; i < x.Count; i++)
        {
            if (!x[i].IsFinite || !y[i].IsFinite)
            {
                throw new GeometryException(
                    GeometryError.NotFinite,
                    string.Create(
                        CultureInfo.InvariantCulture, $"Point {i + 1} of {x.Count} has a coordinate that is not a finite number."));
            }
        }
    }

    private static GeometryException TooFewPlaces(int degree, int distinct, bool coincident) => coincident
        ? new(GeometryError.CoincidentPoints, "All points of the polynomial lie on one another.")
        : new(
            GeometryError.RankDeficient,
            string.Create(
                CultureInfo.InvariantCulture,
                $"A polynomial of degree {degree} needs {degree + 1} different abscissae; the points have {distinct}."));
}
