namespace ErrorMatching.Freeform.Tests;

public sealed class NumbersTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(17)]
    [InlineData(60)]
    public void A_symmetric_matrix_is_the_sum_of_its_eigenvectors(int n)
    {
        var random = new Random(n);
        var matrix = new double[n, n];
        for (var i = 0; i < n; i++)
        {
            for (var j = 0; j <= i; j++)
            {
                matrix[i, j] = matrix[j, i] = random.NextDouble() - 0.5;
            }
        }

        AssertDecomposed(matrix, 1e-13);
    }

    [Fact]
    public void Columns_explain_what_their_orthonormal_columns_explain()
    {
        var random = new Random(3);
        double[] Column() => [.. Enumerable.Range(0, 25).Select(_ => random.NextDouble() - 0.3)];
        var (a, b, c) = (Column(), Column(), Column());

        // The third depends on the first and a constant: it must not count.
        double[][] columns = [a, b, Array.ConvertAll(a, x => (2 * x) - 1), c];
        double[] values = Column();
        var mean = values.Average();
        values = Array.ConvertAll(values, x => x - mean);
        var orthonormal = OrthonormalColumns.Build(columns, []);
        var factor = new CenteredFactor(columns);

        Assert.Equal(3, orthonormal.Length);
        Assert.Equal(3, factor.Rank);
        Assert.Equal(
            orthonormal.Sum(q => Math.Pow(Vectors.Dot(q, values), 2)),
            factor.Share(Array.ConvertAll(columns, q => Vectors.Dot(q, values))),
            1e-12);
    }

    [Theory]
    [InlineData(6, 9)]
    [InlineData(13, 7)]
    public void Waves_on_a_grid_are_those_of_scattered_places(int curves, int each)
    {
        var random = new Random(curves);
        var (i, j) = (new int[curves * each], new int[curves * each]);
        var (u, v, moved, z) = (new double[i.Length], new double[i.Length], new double[i.Length], new double[i.Length]);
        for (var k = 0; k < i.Length; k++)
        {
            // Not in the order of the grid, and not evenly spaced.
            var at = (k * 31) % i.Length;
            (i[k], j[k]) = (at % each, at / each);
            u[k] = (2 * Math.Pow(i[k] / (each - 1.0), 1.2)) - 1;
            v[k] = (2.0 * j[k] / (curves - 1)) - 1;
            moved[k] = u[k] + ((random.NextDouble() - 0.5) * 1e-7);
            z[k] = Math.Sin(4 * u[k]) + Math.Cos(7 * v[k]) + random.NextDouble();
        }

        var mean = z.Average();
        var length = Math.Sqrt(z.Sum(x => (x - mean) * (x - mean)));
        var unit = Array.ConvertAll(z, x => (x - mean) / length);
        var (grid, scattered) = (new FieldData(i, j, u, v, z), new FieldData(i, j, moved, v, z));
        Assert.NotNull(grid.Grid);
        Assert.Null(scattered.Grid);
        var (onGrid, apart) = (WaveBasis.Build(grid), WaveBasis.Build(scattered));
        foreach (var only in new Func<double, double, bool>[] { (_, _) => true, (a, _) => a == 0, (_, b) => b == 0, (a, b) => a * b == 1 })
        {
            var (expected, found) = (apart.Strongest(unit, only), onGrid.Strongest(unit, only));

            Assert.Equal((expected.U, expected.V), (found.U, found.V));
            Assert.Equal(expected.Score, found.Score, 1e-4);
        }
    }

    [Fact]
    public void Four_columns_of_a_factor_at_once_are_those_of_one_after_the_other()
    {
        // A band matrix, full and narrower than a vector, so that every remainder of four occurs.
        foreach (var (n, width) in new[] { (23, 23), (23, 9), (12, 3) })
        {
            var random = new Random(n + width);
            var rows = new double[n][];
            for (var r = 0; r < n; r++)
            {
                rows[r] = new double[Math.Min(r, width) + 1];
                for (var c = 0; c < rows[r].Length; c++)
                {
                    rows[r][c] = c + 1 == rows[r].Length ? 10 + random.NextDouble() : random.NextDouble() - 0.5;
                }
            }

            var expected = Array.ConvertAll(rows, row => (double[])row.Clone());
            for (var r = 0; r < n; r++)
            {
                var first = Math.Max(0, r - width);
                for (var c = first; c <= r; c++)
                {
                    var other = expected[c].AsSpan(first - Math.Max(0, c - width));
                    var left = expected[r][c - first] - Vectors.Dot(expected[r].AsSpan(0, c - first), other);
                    expected[r][c - first] = c < r ? left / other[^1] : Math.Sqrt(left);
                }
            }

            Assert.NotNull(BandedCholesky.Factor(rows, width));
            Assert.Equal(expected, rows);
        }
    }

    [Fact]
    public void Eigenvalues_of_a_chain_are_known()
    {
        // 2 on the diagonal, -1 beside it: 2 - 2 cos(k pi / (n + 1)).
        const int n = 30;
        var eigen = new SymmetricEigen(Rows(n, (i, j) => i == j ? 2 : Math.Abs(i - j) == 1 ? -1 : 0));

        Assert.Equal(
            Enumerable.Range(1, n).Select(k => 2 - (2 * Math.Cos(k * Math.PI / (n + 1)))),
            eigen.Values.Order(),
            (a, b) => Math.Abs(a - b) < 1e-13);
    }

    [Fact]
    public void Eigenvalues_far_below_rounding_do_no_harm()
    {
        // A smooth kernel: its eigenvalues fall from some 50 to below 1e-17.
        var matrix = new double[100, 100];
        for (var i = 0; i < 100; i++)
        {
            for (var j = 0; j < 100; j++)
            {
                matrix[i, j] = Math.Exp(-Math.Pow((i - j) / 40.0, 2));
            }
        }

        AssertDecomposed(matrix, 1e-12);
    }

    [Fact]
    public void A_diagonal_matrix_and_one_of_zeros_stay_what_they_are()
    {
        Assert.Equal([1.0, 2.0, 3.0], new SymmetricEigen(Rows(3, (i, j) => i == j ? i + 1 : 0)).Values.Order());
        Assert.Equal([0.0, 0.0], new SymmetricEigen(Rows(2, (_, _) => 0)).Values);
    }

    [Fact]
    public void The_minimum_of_a_function_of_one_number_is_found_with_few_questions()
    {
        var asked = 0;
        var place = LineMinimum.Find(x => { asked++; return Math.Pow(x - 0.7, 2) + Math.Pow(x - 0.7, 4); }, -1, 2, 1e-7);

        Assert.Equal(0.7, place, 1e-6);
        Assert.InRange(asked, 3, 25);
        Assert.Equal(0.25, LineMinimum.Find(x => Math.Abs(x - 0.25), 0, 1, 1e-7), 1e-6);
        Assert.Equal(2, LineMinimum.Find(x => -x, 0, 2, 1e-7), 1e-6);
    }

    [Fact]
    public void A_function_without_finite_values_ends_the_search_somewhere_inside() =>
        Assert.InRange(LineMinimum.Find(_ => double.PositiveInfinity, 0, 1, 1e-7), 0, 1);

    [Fact]
    public void A_column_that_nearly_depends_on_another_is_orthogonalized_again()
    {
        // Beside 1, the second column has 1e-9 left; the coefficients are exact.
        double[] one = [1, 1, 1, 1], nearly = [1 + 1e-9, 1 - 1e-9, 1 + 1e-9, 1 - 1e-9];
        var fit = LeastSquares.Solve([one, nearly], [3, 1, 3, 1])!;

        Assert.Equal(0, fit.SquareSum, 1e-20);
        Assert.Equal(1e9, fit.Coefficients[1], 1e3);
        Assert.Null(LeastSquares.Solve([one, one], [3, 1, 3, 1]));
    }

    private static void AssertDecomposed(double[,] matrix, double tolerance)
    {
        var n = matrix.GetLength(0);
        var eigen = new SymmetricEigen(Rows(n, (i, j) => matrix[i, j]));
        for (var i = 0; i < n; i++)
        {
            for (var j = 0; j < n; j++)
            {
                Assert.Equal(i == j ? 1 : 0, Vectors.Dot(eigen.Vectors[i], eigen.Vectors[j]), tolerance);
                Assert.Equal(
                    matrix[i, j], Enumerable.Range(0, n).Sum(k => eigen.Values[k] * eigen.Vectors[k][i] * eigen.Vectors[k][j]), tolerance);
            }
        }
    }

    private static double[][] Rows(int n, Func<int, int, double> element) =>
        [.. Enumerable.Range(0, n).Select(i => Enumerable.Range(0, n).Select(j => element(i, j)).ToArray())];
}
