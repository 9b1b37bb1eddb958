namespace ErrorMatching.Freeform;

/// <summary>A bicubic spline with about as many poles as the grid has lines, smoothed by the bending energy of a thin plate (Green and
/// Silverman, Nonparametric Regression and Generalized Linear Models, section 7.9). The weight minimizes the line-out error, or is so small
/// that the spline passes through the values.</summary>
internal sealed class SplineModel : FieldModel
{
    /// <summary>Maximum number of pieces along one axis, which determines the bandwidth of the equations.</summary>
    private const int MostPieces = 24;

    /// <summary>A weight that moves the spline by less than a hundred-thousandth of what it bends.</summary>
    private const double Through = 1e-11;

    private static readonly double[] Weights = [1e-9, 1e-7, 1e-5, 1e-3, 1e-1];

    private readonly SplineEquations _equations;
    private readonly SplineAxis _u;
    private readonly SplineAxis _v;
    private readonly double _weight;
    private readonly BandedCholesky _factor;
    private readonly double[] _poles;
    private double? _freedom;
    private double? _noise;

    private SplineModel(FieldData data, SplineEquations equations, double weight, BandedCholesky factor, double[] poles)
        : base(data)
    {
        (_equations, _u, _v, _weight, _factor, _poles) = (equations, equations.U, equations.V, weight, factor, poles);
    }

    public override FieldModelKind Kind => _weight == Through ? FieldModelKind.Interpolant : FieldModelKind.CubicSpline;

    /// <summary>Of a spline through the values: the mean absolute residual of the model that misses a part of them; otherwise 0.</summary>
    public double Missed { get; private set; }

    public override double Freedom => _freedom ??= Trace();

    public override double Noise => _noise ??= Math.Sqrt(Residuals().Sum(r => r * r) / Math.Max(1, Data.Count - Freedom));

    public override int DegreeU => 3;

    public override int DegreeV => 3;

    public override IEnumerable<(double At, int Smoothness)> JoinsU => _u.Breaks[1..^1].ToArray().Select(at => (at, 2));

    public override IEnumerable<(double At, int Smoothness)> JoinsV => _v.Breaks[1..^1].ToArray().Select(at => (at, 2));

    /// <summary>Returns the spline with the best of several weights; null if there are too few lines.</summary>
    public static SplineModel? Run(FieldData data)
    {
        var few = data.Thinned(FieldData.EnoughLines);
        if (Over(few) is not { } equations)
        {
            return null;
        }

        var best = Weights.Select(weight => Fit(few, equations, weight)).OfType<SplineModel>().MinBy(model => model.LineOut);
        return best is null || few == data ? best : Fit(data, Over(data)!, best._weight);
    }

    /// <summary>Returns the spline through all values; null if there are too few lines, or so many that a piece spans several.</summary>
    /// <param name="data">The values.</param>
    /// <param name="smooth">The model that misses a part of them. Nothing tells how much of what it leaves is noise, so all of it may
    /// be.</param>
    public static SplineModel? Interpolate(FieldData data, FieldModel smooth)
    {
        if (data.Crossings.Length > MostPieces + 1 || data.Curves.Length > MostPieces + 1 || Over(data) is not { } equations)
        {
            return null;
        }

        var model = Fit(data, equations, Through);
        if (model is not null)
        {
            (model._noise, model.Missed) = (smooth.Noise, smooth.Residuals().Average(Math.Abs));
        }

        return model;
    }

    public override double At(double u, double v)
    {
        var (a, b) = (_u.At(u), _v.At(v));
        var sum = 0.0;
        for (var i = 0; i < 4; i++)
        {
            for (var j = 0; j < 4; j++)
            {
                sum += a.Values[i] * b.Values[j] * _poles[((a.First + i) * _v.Count) + b.First + j];
            }
        }

        return sum;
    }

    public override double VarianceAt(double u, double v, double noise)
    {
        var forward = _factor.Forward(Row(u, v));
        return noise * noise * LeastSquares.Product(forward, forward);
    }

    public override FieldModel? Refit(FieldData other) => Fit(other, _equations, _weight);

    private static SplineModel? Fit(FieldData data, SplineEquations equations, double weight)
    {
        var (rows, right) = equations.Of(data, weight);
        return BandedCholesky.Factor(rows, equations.Width) is { } factor
            ? new(data, equations, weight, factor, factor.Solve(right))
            : null;
    }

    private static SplineEquations? Over(FieldData data)
    {
        var (u, v) = data.LinePlaces();
        return u.Length < 2 || v.Length < 2 ? null : new(SplineAxis.Over(u, MostPieces), SplineAxis.Over(v, MostPieces));
    }

    private double[] Row(double u, double v)
    {
        var (a, b) = (_u.At(u), _v.At(v));
        var row = new double[_poles.Length];
        for (var i = 0; i < 16; i++)
        {
            row[((a.First + (i / 4)) * _v.Count) + b.First + (i % 4)] = a.Values[i / 4] * b.Values[i % 4];
        }

        return row;
    }

    /// <summary>The sum of the leverages. If there are many values, an evenly chosen subset is scaled up.</summary>
    private double Trace()
    {
        var step = Math.Max(1, Data.Count / 100);
        var (sum, count) = (0.0, 0);
        for (var k = 0; k < Data.Count; k += step)
        {
            sum += VarianceAt(Data.U[k], Data.V[k], 1);
            count++;
        }

        return sum * Data.Count / count;
    }
}
