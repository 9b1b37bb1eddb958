namespace ErrorMatching.Freeform;

/// <summary>The covariance of values on a rectangular grid: the Kronecker product of one small matrix per direction, decomposed separately
/// (Saatci, Scalable Inference for Structured Gaussian Process Models, 2011, chapter 5).</summary>
internal sealed class GridCovariance : Covariance
{
    private readonly SampleGrid _grid;
    private readonly Kernel _kernel;
    private readonly SymmetricEigen _u;
    private readonly SymmetricEigen _v;
    private readonly double[] _values;

    public GridCovariance(SampleGrid grid, Kernel kernel, GridCovariance? like)
    {
        (_grid, _kernel) = (grid, kernel);
        _u = like is not null && like._grid.U.AsSpan().SequenceEqual(grid.U) ? like._u : new(Matrix(grid.U, kernel.AlongU));
        _v = like is not null && like._grid.V.AsSpan().SequenceEqual(grid.V) ? like._v : new(Matrix(grid.V, kernel.AlongV));
        var noise = Math.Max(kernel.Noise, Kernel.LeastNoise);
        _values = new double[grid.U.Length * grid.V.Length];
        for (var k = 0; k < _values.Length; k++)
        {
            // Negative eigenvalues are due to rounding.
            _values[k] = (Math.Max(0, _u.Values[k / grid.V.Length]) * Math.Max(0, _v.Values[k % grid.V.Length])) + noise;
        }
    }

    public override double LogDeterminant => _values.Sum(Math.Log);

    public override double InverseTrace => _values.Sum(x => 1 / x);

    public override double[] Solve(double[] b)
    {
        var (n, m) = (_grid.U.Length, _grid.V.Length);
        var x = ToBasis(b);
        for (var k = 0; k < x.Length; k++)
        {
            x[k] /= _values[k];
        }

        x = ApplyAcross(_v.Vectors, x, n, transposed: true);
        x = Apply(_u.Vectors, x, m, transposed: true);
        var result = new double[b.Length];
        for (var k = 0; k < x.Length; k++)
        {
            result[_grid.Index[k]] = x[k];
        }

        return result;
    }

    /// <inheritdoc/>
    /// <remarks>The basis is that of the eigenvectors.</remarks>
    public override double[] ToBasis(double[] b)
    {
        var x = new double[b.Length];
        for (var k = 0; k < x.Length; k++)
        {
            x[k] = b[_grid.Index[k]];
        }

        return ApplyAcross(_v.Vectors, Apply(_u.Vectors, x, _grid.V.Length, transposed: false), _grid.U.Length, transposed: false);
    }

    public override double[] RowInBasis(double u, double v)
    {
        // The row is the product of a row along u and one along v. So is its image.
        var (a, b) = Rows(u, v);
        var (x, y) = (ApplyAcross(_u.Vectors, a, 1, transposed: false), ApplyAcross(_v.Vectors, b, 1, transposed: false));
        var row = new double[_values.Length];
        for (var i = 0; i < x.Length; i++)
        {
            Vectors.Subtract(row.AsSpan(i * y.Length, y.Length), -x[i], y);
        }

        return row;
    }

    public override double[] SolveInBasis(double[] b)
    {
        var x = new double[b.Length];
        for (var k = 0; k < x.Length; k++)
        {
            x[k] = b[k] / _values[k];
        }

        return x;
    }

    public override double Sum(double u, double v, double[] weights)
    {
        var (a, b) = Rows(u, v);
        var sum = 0.0;
        for (var i = 0; i < a.Length; i++)
        {
            var part = 0.0;
            for (var j = 0; j < b.Length; j++)
            {
                part += b[j] * weights[_grid.Index[(i * b.Length) + j]];
            }

            sum += a[i] * part;
        }

        return sum;
    }

    private (double[] U, double[] V) Rows(double u, double v)
    {
        var kernel = _kernel;
        return (Array.ConvertAll(_grid.U, x => kernel.AlongU(u, x)), Array.ConvertAll(_grid.V, x => kernel.AlongV(v, x)));
    }

    private static double[][] Matrix(double[] places, Func<double, double, double> kernel) =>
        Array.ConvertAll(places, a => Array.ConvertAll(places, b => kernel(a, b)));

    /// <summary>Multiplies the matrix of eigenvectors with a grid of values, along u.</summary>
    private static double[] Apply(double[][] vectors, double[] x, int width, bool transposed)
    {
        var result = new double[x.Length];
        for (var i = 0; i < vectors.Length; i++)
        {
            for (var k = 0; k < vectors.Length; k++)
            {
                Vectors.Subtract(result.AsSpan(i * width, width), transposed ? -vectors[k][i] : -vectors[i][k], x.AsSpan(k * width, width));
            }
        }

        return result;
    }

    /// <summary>Multiplies the matrix of eigenvectors with a grid of values, along v.</summary>
    private static double[] ApplyAcross(double[][] vectors, double[] x, int height, bool transposed)
    {
        var width = vectors.Length;
        var result = new double[x.Length];
        for (var i = 0; i < height; i++)
        {
            var from = x.AsSpan(i * width, width);
            var to = result.AsSpan(i * width, width);
            for (var k = 0; k < width; k++)
            {
                if (transposed)
                {
                    Vectors.Subtract(to, -from[k], vectors[k]);
                }
                else
                {
                    to[k] = Vectors.Dot(vectors[k], from);
                }
            }
        }

        return result;
    }
}
