namespace ErrorMatching.Geometry.Tests.Numbers;

public class PolynomialTests
{
    [Fact]
    public void Value_is_the_sum_of_the_powers() => Assert.Equal(2 - (3 * 4) + (5 * 16), new Polynomial(2, -3, 5).Evaluate(4));

    [Fact]
    public void Derivative_lowers_each_power() => Assert.Equal(new Polynomial(-3, 10), new Polynomial(2, -3, 5).Derivative());

    [Fact]
    public void Derivative_of_a_constant_is_zero() => Assert.Equal(new Polynomial(0), new Polynomial(7).Derivative());

    [Fact]
    public void Zeros_at_the_end_do_not_raise_the_degree() => Assert.Equal(1, new Polynomial(1, 2, 0, 0).Degree);

    [Fact]
    public void No_coefficient_means_zero() => Assert.Equal(0, new Polynomial().Evaluate(3));

    [Fact]
    public void Equal_coefficients_make_equal_polynomials()
    {
        Assert.Equal(new Polynomial(1, 2), new Polynomial(1, 2, 0));
        Assert.Equal(new Polynomial(1, 2).GetHashCode(), new Polynomial(1, 2).GetHashCode());
        Assert.NotEqual(new Polynomial(1, 2), new Polynomial(2, 1));
        Assert.False(new Polynomial(1).Equals((object)1.0));
    }

    [Fact]
    public void Coefficient_that_is_no_number_is_refused() =>
        Assert.Equal(GeometryError.NotFinite, Assert.Throws<GeometryException>(() => new Polynomial(1, double.NaN)).Error);
}
