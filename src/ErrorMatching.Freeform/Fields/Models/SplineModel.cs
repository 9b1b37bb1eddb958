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

    private readonly SplineAxis _u;
    private readonly SplineAxis _v;
    private readonly double _weight;
    private readonly double[][] _bending;
    private readonly Cholesky _factor;
    private readonly double[] _poles;
    private double? _freedom;
    private double? _noise;

    private SplineModel(FieldData data, SplineAxis u, SplineAxis v, double weight, double[][] bending, Cholesky factor, double[] poles)
        : base(data)
    {
        (_u, _v, _weight, _bending, _factor, _poles) = (u, v, weight, bending, factor, poles);
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
        var (u, v) = data.LinePlaces();
        if (u.Length < 2 || v.Length < 2)
        {
            return null;
        }

        var (axisU, axisV) = (SplineAxis.Over(u, MostPieces), SplineAxis.Over(v, MostPieces));
        var few = data.Thinned(FieldData.EnoughLines);
        var bending = Bending(axisU, axisV);
        var best = Weights.Select(weight => Fit(few, axisU, axisV, weight, bending)).OfType<SplineModel>().MinBy(model => model.LineOut);
        return best is null || few == data ? best : Fit(data, axisU, axisV, best._weight, bending);
    }

    /// <summary>Returns the spline through all values; null if there are too few lines, or so many that a piece spans several.</summary>
    /// <param name="data">The values.</param>
    /// <param name="smooth">The model that misses a part of them. Nothing tells how much of what it leaves is noise, so all of it may
    /// be.</param>
    public static SplineModel? Interpolate(FieldData data, FieldModel smooth)
    {
        var (u, v) = data.LinePlaces();
        if (u.Length < 2 || v.Length < 2 || u.Length > MostPieces + 1 || v.Length > MostPieces + 1)
        {
            return null;
        }

        var (axisU, axisV) = (SplineAxis.Over(u, MostPieces), SplineAxis.Over(v, MostPieces));
        var model = Fit(data, axisU, axisV, Through, Bending(axisU, axisV));
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

    public override FieldModel? Refit(FieldData other) => Fit(other, _u, _v, _weight, _bending);

    private static SplineModel? Fit(FieldData data, SplineAxis u, SplineAxis v, double weight, double[][] bending)
    {
        var width = Width(v);
        var rows = Array.ConvertAll(bending, row => Array.ConvertAll(row, x => weight * data.Count * x));
        var right = new double[rows.Length];
        for (var k = 0; k < data.Count; k++)
        {
            var (a, b) = (u.At(data.U[k]), v.At(data.V[k]));
            for (var i = 0; i < 16; i++)
            {
                var row = ((a.First + (i / 4)) * v.Count) + b.First + (i % 4);
                var factor = a.Values[i / 4] * b.Values[i % 4];
                right[row] += factor * data.Z[k];
                for (var p = 0; p <= i / 4; p++)
                {
                    var to = rows[row].AsSpan(((a.First + p) * v.Count) + b.First - Math.Max(0, row - width));
                    var share = factor * a.Values[p];
                    var last = p < i / 4 ? 3 : i % 4;
                    for (var q = 0; q <= last; q++)
                    {
                        to[q] += share * b.Values[q];
                    }
                }
            }
        }

        return Cholesky.Factor(rows, width) is { } cholesky ? new(data, u, v, weight, bending, cholesky, cholesky.Solve(right)) : null;
    }

    /// <summary>Bandwidth of the equations left of the diagonal.</summary>
    private static int Width(SplineAxis v) => (3 * v.Count) + 3;

    /// <summary>The integral of f_uu^2 + 2 f_uv^2 + f_vv^2 as a quadratic form of the poles. Row i has columns i - width to i.</summary>
    private static double[][] Bending(SplineAxis u, SplineAxis v)
    {
        var (u0, u1, u2) = (u.Products(0), u.Products(1), u.Products(2));
        var (v0, v1, v2) = (v.Products(0), v.Products(1), v.Products(2));
        var width = Width(v);
        var rows = new double[u.Count * v.Count][];
        for (var row = 0; row < rows.Length; row++)
        {
            rows[row] = new double[Math.Min(row, width) + 1];
            var (i, j) = (row / v.Count, row % v.Count);
            for (var k = Math.Max(0, i - 3); k <= i; k++)
            {
                for (var l = Math.Max(0, j - 3); l <= Math.Min(v.Count - 1, j + 3); l++)
                {
                    var column = (k * v.Count) + l;
                    if (column <= row)
                    {
                        // A trace of the values themselves keeps planes determined where lines are missing.
                        rows[row][column - Math.Max(0, row - width)] = (u2[i][k] * v0[j][l]) + (2 * u1[i][k] * v1[j][l])
                            + (u0[i][k] * v2[j][l]) + (1e-9 * u0[i][k] * v0[j][l]);
                    }
                }
            }
        }

        return rows;
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
