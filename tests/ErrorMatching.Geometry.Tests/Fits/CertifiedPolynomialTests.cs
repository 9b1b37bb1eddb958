namespace ErrorMatching.Geometry.Tests.Fits;

/// <summary>The certified polynomial sets of NIST, judged in digits (log relative error). They certify 15 digits.</summary>
public class CertifiedPolynomialTests
{
    public static TheoryData<string> Sets => ["Norris", "Pontius", "Filip", "Wampler1", "Wampler2", "Wampler3", "Wampler4", "Wampler5"];

    [Theory]
    [MemberData(nameof(Sets))]
    public void Coefficients_and_errors_keep_fourteen_digits(string name)
    {
        var set = NistSet.Read(name);
        var fit = PolynomialFit.Fit(set.X, set.Y, new() { Degree = set.Coefficients.Count - 1 });
        for (var k = 0; k <= fit.Degree; k++)
        {
            Assert.True(
                NistSet.Digits(fit.Coefficients[k], set.Coefficients[k]) >= 14,
                $"B{k}: {fit.Coefficients[k]:R}, certified {set.Coefficients[k]:R}");
            Assert.True(
                NistSet.Digits(fit.StandardErrors[k], set.StandardErrors[k]) >= 14,
                $"error of B{k}: {fit.StandardErrors[k]:R}, certified {set.StandardErrors[k]:R}");
        }

        Assert.True(
            NistSet.Digits(fit.ResidualStandardDeviation, set.ResidualStandardDeviation) >= 14, $"{fit.ResidualStandardDeviation:R}");
    }

    [Fact]
    public void Filip_is_evaluated_from_its_basis_where_powers_lose_digits()
    {
        // The residuals are formed in double-double; a value from the basis must agree with them to rounding, one from the powers cannot.
        var set = NistSet.Read("Filip");
        var fit = PolynomialFit.Fit(set.X, set.Y, new() { Degree = 10 });
        for (var i = 0; i < set.X.Count; i++)
        {
            Assert.Equal(set.Y[i].ToDouble() - fit.Residuals[i], fit.Evaluate(set.X[i].ToDouble()), 13);
        }
    }

    [Fact]
    public void Order_of_the_points_does_not_change_a_bit()
    {
        var set = NistSet.Read("Filip");
        var fit = PolynomialFit.Fit(set.X, set.Y);
        var reversed = PolynomialFit.Fit([.. set.X.Reverse()], [.. set.Y.Reverse()]);
        Assert.Equal(fit.Coefficients, reversed.Coefficients);
        Assert.Equal(fit.StandardErrors, reversed.StandardErrors);
        Assert.Equal(fit.LeaveOneOutRms, reversed.LeaveOneOutRms);
        Assert.Equal(fit.Residuals, reversed.Residuals.Reverse());
    }

    [Fact]
    public void Exact_sets_choose_their_own_degree()
    {
        var set = NistSet.Read("Wampler1");
        var fit = PolynomialFit.Fit(set.X, set.Y, new() { Ridge = null });
        Assert.Equal((5, 0.0), (fit.Degree, fit.Ridge));
    }
}
