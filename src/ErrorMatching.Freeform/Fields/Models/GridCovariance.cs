using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The covariance of values on a rectangular grid: the Kronecker product of one small matrix per direction, decomposed separately
/// (Saatci, Scalable Inference for Structured Gaussian Process Models, 2011, chapter 5).</summary>
internal sealed class GridCovariance : Covariance
{
    // An eigenvalue below this share of the largest is rounding, and so is a part along its vector of the kernel at any place.
    private const double Nothing = 1e-15;

    private readonly SampleGrid _grid;
    private readonly Kernel _kernel;
    private readonly SymmetricEigen _u;
    private readonly SymmetricEigen _v;
    private readonly double[] _values;
    private readonly int _leadingU;
    private readonly int _leadingV;

    public GridCovariance(SampleGrid grid, Kernel kernel, GridCovariance? like)
    {
        (_grid, _kernel) = (grid, kernel);
        _u = like is not null && like._grid.U.AsSpan().SequenceEqual(grid.U) ? like._u : new(Matrix(grid.U, kernel.AlongU));
        _v = like is not null && like._grid.V.AsSpan().SequenceEqual(grid.V) ? like._v : new(Matrix(grid.V, kernel.AlongV));
        (_leadingU, _leadingV) = (LeadingOf(_u), LeadingOf(_v));
        var noise = Math.Max(kernel.Noise, Kernel.LeastNoise);
        _values = new double[grid.U.Length * grid.V.Length];
        for (var k = 0; k < _values.Length; k++)
        {
            // Negative eigenvalues are due to rounding.
            _values[k] = (Math.Max(0, _u.Values[k / grid.V.Length]) * Math.Max(0, _v.Values[k % grid.V.Length])) + noise;
        }
    }

    public override double LogDeterminant
    {
        get
        {
            var sum = 0.0;
            foreach (var value in _values)
            {
                sum += Elementary.Log(value);
            }

            return sum;
        }
    }

    public override double InverseTrace => _values.Sum(x => 1 / x);

    public override int Leading => _leadingU * _leadingV;

    public override double[] Solve(double[] b)
    {
        var (n, m) = (_grid.U.Length, _grid.V.Length);
        var x = Apart(b);
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
    /// <remarks>The basis is that of the eigenvectors. Leading are those with both eigenvalues above rounding.</remarks>
    public override double[] ToBasis(double[] b)
    {
        var (x, m) = (Apart(b), _grid.V.Length);
        var result = new double[x.Length];
        var (leading, other) = (0, Leading);
        for (var k = 0; k < x.Length; k++)
        {
            result[k / m < _leadingU && k % m < _leadingV ? leading++ : other++] = x[k];
        }

        return result;
    }

    /// <inheritdoc/>
    /// <remarks>The row is the product of a row along u and one along v. So is its image.</remarks>
    public override double[] RowInBasis(double u, double v)
    {
        Span<double> alongU = stackalloc double[_leadingU];
        Span<double> alongV = stackalloc double[_leadingV];
        Along(u, v, alongU, alongV);
        var row = new double[Leading];
        for (var i = 0; i < alongU.Length; i++)
        {
            Vectors.Subtract(row.AsSpan(i * alongV.Length, alongV.Length), -alongU[i], alongV);
        }

        return row;
    }

    public override double Sum(double u, double v, double[] weights)
    {
        Span<double> alongU = stackalloc double[_leadingU];
        Span<double> alongV = stackalloc double[_leadingV];
        Along(u, v, alongU, alongV);
        var sum = 0.0;
        for (var i = 0; i < alongU.Length; i++)
        {
            sum += alongU[i] * Vectors.Dot(alongV, weights.AsSpan(i * alongV.Length, alongV.Length));
        }

        return sum;
    }

    public override double[] SolveInBasis(double[] b)
    {
        var x = new double[b.Length];
        for (var k = 0; k < x.Length; k++)
        {
            x[k] = b[k] / _values[(k / _leadingV * _grid.V.Length) + (k % _leadingV)];
        }

        return x;
    }

    // The kernel between a place and each line, as leading parts of the eigenvectors of each direction.
    private void Along(double u, double v, Span<double> alongU, Span<double> alongV)
    {
        Span<double> kernel = stackalloc double[MostLines];
        var lines = kernel[.._grid.U.Length];
        for (var i = 0; i < lines.Length; i++)
        {
            lines[i] = _kernel.AlongU(u, _grid.U[i]);
        }

        for (var i = 0; i < alongU.Length; i++)
        {
            alongU[i] = Vectors.Dot(lines, _u.Vectors[i]);
        }

        lines = kernel[.._grid.V.Length];
        for (var j = 0; j < lines.Length; j++)
        {
            lines[j] = _kernel.AlongV(v, _grid.V[j]);
        }

        for (var j = 0; j < alongV.Length; j++)
        {
            alongV[j] = Vectors.Dot(lines, _v.Vectors[j]);
        }
    }

    private static int LeadingOf(SymmetricEigen eigen)
    {
        var count = eigen.Values.Length;
        while (count > 1 && !(eigen.Values[count - 1] > Nothing * eigen.Values[0]))
        {
            count--;
        }

        return count;
    }

    /// <summary>The parts of one number per value along the eigenvectors.</summary>
    private double[] Apart(double[] b)
    {
        var x = new double[b.Length];
        for (var k = 0; k < x.Length; k++)
        {
            x[k] = b[_grid.Index[k]];
        }

        return ApplyAcross(_v.Vectors, Apply(_u.Vectors, x, _grid.V.Length, transposed: false), _grid.U.Length, transposed: false);
    }

    private static double[][] Matrix(double[] places, Func<double, double, double> kernel)
    {
        var rows = new double[places.Length][];
        for (var i = 0; i < rows.Length; i++)
        {
            rows[i] = new double[places.Length];
            for (var j = 0; j < rows.Length; j++)
            {
                rows[i][j] = j < i ? rows[j][i] : kernel(places[i], places[j]);
            }
        }

        return rows;
    }

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
