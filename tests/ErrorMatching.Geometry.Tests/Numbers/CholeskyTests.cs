using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Geometry.Tests;

public sealed class CholeskyTests
{
    // Of [4 2; 2 5] the factor is [2 0; 1 2], by hand.
    [Fact]
    public void A_small_matrix_has_the_factor_of_the_textbook()
    {
        double[] matrix = [4, double.NaN, 2, 5];
        var factor = Cholesky.Factor(matrix, 2)!;

        Assert.Equal([2.0, 1, 2], [matrix[0], matrix[2], matrix[3]]);
        Assert.Equal((2, 2), (factor.Pivot(0), factor.Pivot(1)));
        double[] half = [2, 3], whole = [2, 3];
        factor.Forward(half);
        factor.Solve(whole);
        Assert.Equal([1.0, 1], half);
        Assert.Equal([0.25, 0.5], whole);
        Assert.Equal(2, factor.Form([2, 3]));
    }

    // Math.NET Numerics reduces by columns and solves from the nearest unknown on, so not even the last digit differs.
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7)]
    [InlineData(60)]
    public void Factor_and_solution_are_those_of_another_library(int n)
    {
        var random = new Random(n);
        var roots = Matrix<double>.Build.Dense(n, n, (_, _) => random.NextDouble() - 0.5);
        var given = (roots * roots.Transpose()) + (0.01 * Matrix<double>.Build.DenseIdentity(n));
        var right = Vector<double>.Build.Dense(n, _ => random.NextDouble());
        var expected = given.Cholesky();

        var matrix = given.ToRowMajorArray();
        var factor = Cholesky.Factor(matrix, n)!;
        var solved = right.ToArray();
        factor.Solve(solved);

        Assert.Equal(expected.Solve(right).ToArray(), solved);
        for (var i = 0; i < n; i++)
        {
            Assert.Equal(expected.Factor.Row(i).ToArray()[..(i + 1)], matrix[(i * n)..((i * n) + i + 1)]);
        }

        var half = right.ToArray();
        factor.Forward(half);
        Assert.Equal(factor.Form(right.ToArray()), half.Sum(y => y * y), factor.Form(right.ToArray()) * 1e-12);
    }

    [Fact]
    public void Only_positive_definite_matrices_have_a_factor()
    {
        Assert.Null(Cholesky.Factor([1, 0, 1, 1], 2));
        Assert.Null(Cholesky.Factor([double.NaN], 1));
        Assert.NotNull(Cholesky.Factor([1, 0, 1, 1 + 1e-15], 2));
        Assert.NotNull(Cholesky.Factor([], 0));
        Assert.Throws<ArgumentException>(() => Cholesky.Factor([1, 2], 2));
    }
}
