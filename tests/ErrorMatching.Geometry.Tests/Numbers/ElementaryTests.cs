using System.Globalization;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Numbers;

/// <summary>The judges are mpmath, with 40 digits of each value in <c>Data/elementary.csv</c>, and laws.</summary>
public class ElementaryTests
{
    private static readonly Dictionary<string, Func<double, double, double>> Functions = new()
    {
        ["Exp"] = (x, _) => Elementary.Exp(x),
        ["Log"] = (x, _) => Elementary.Log(x),
        ["Log10"] = (x, _) => Elementary.Log10(x),
        ["Pow"] = Elementary.Pow,
        ["Sin"] = (x, _) => Elementary.Sin(x),
        ["Cos"] = (x, _) => Elementary.Cos(x),
        ["Tan"] = (x, _) => Elementary.Tan(x),
        ["Asin"] = (x, _) => Elementary.Asin(x),
        ["Acos"] = (x, _) => Elementary.Acos(x),
        ["Atan"] = (x, _) => Elementary.Atan(x),
        ["Atan2"] = Elementary.Atan2,
    };

    private static readonly Gen<double> Number =
        Gen.Choose(int.MinValue, int.MaxValue).Zip(Gen.Choose(-40, 12)).Select(n => n.Item1 * Math.ScaleB(1, n.Item2 - 24));

    public static TheoryData<string> Names => [.. Functions.Keys];

    [Theory]
    [MemberData(nameof(Names))]
    public void Values_are_within_half_a_unit_of_the_last_place_and_a_hundredth(string name)
    {
        var rows = ElementaryValues.Of(name);
        Assert.True(rows.Count >= 40);
        Assert.All(rows, row =>
        {
            var value = Functions[name](row.X, row.Y);
            var error = DoubleDouble.Abs(value - row.Value).ToDouble() / (Math.BitIncrement(Math.Abs(value)) - Math.Abs(value));
            Assert.True(error <= 0.51, $"{name}({row.X:R}, {row.Y:R}) is {value:R}, which is off by {error} units.");
        });
    }

    [Fact]
    public void Values_of_exact_arguments_are_exact()
    {
        Assert.Equal((1.0, Math.E), (Elementary.Exp(0), Elementary.Exp(1)));
        Assert.Equal((0.0, 1.0), (Elementary.Log(1), Elementary.Log(Math.E)));
        Assert.Equal((0.0, 1.0), Elementary.SinCos(0));
        Assert.Equal((0.0, Math.PI / 2), (Elementary.Acos(1), Elementary.Acos(0)));
        Assert.Equal((Math.PI / 2, Math.PI), (Elementary.Asin(1), Elementary.Acos(-1)));
        Assert.Equal((Math.PI / 4, -3 * Math.PI / 4), (Elementary.Atan(1), Elementary.Atan2(-1, -1)));
        Assert.Equal((Math.PI / 2, 0.0), (Elementary.Atan2(3, 0), Elementary.Atan2(0, 3)));
        for (var k = -22; k <= 22; k++)
        {
            var power = double.Parse($"1e{k}", CultureInfo.InvariantCulture);
            Assert.Equal((power, (double)k), (Elementary.Pow(10, k), Elementary.Log10(power)));
            Assert.Equal(Math.ScaleB(1, 40 * k), Elementary.Pow(2, 40 * k));
        }

        for (var k = 0L; k <= 208_000; k += 99)
        {
            Assert.Equal((k * k, k * k * k), (Elementary.Pow(k, 2), Elementary.Pow(k, 3)));
            Assert.Equal((double)k, Elementary.Pow(k * k, 0.5));
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Zeros_infinities_and_what_is_undefined_are_those_of_the_runtime(string name)
    {
        double[] special = [
            0, 1, 0.5, 2, 3, 1e-300, 5e-324, 1e300, double.MaxValue, double.PositiveInfinity, 9007199254740991, 9007199254740992];
        foreach (var x in special.Concat(special.Select(s => -s)).Append(double.NaN))
        {
            foreach (var y in special.Concat(special.Select(s => -s)).Append(double.NaN))
            {
                var (expected, found) = (Judge(name, x, y), Functions[name](x, y));
                var isLimit = expected == 0 || !double.IsFinite(expected);
                Assert.True(
                    isLimit ? BitConverter.DoubleToInt64Bits(expected) == BitConverter.DoubleToInt64Bits(found)
                            || (double.IsNaN(expected) && double.IsNaN(found))
                        : Math.Abs(found - expected) <= 2 * (Math.BitIncrement(Math.Abs(expected)) - Math.Abs(expected)),
                    $"{name}({x:R}, {y:R}) is {found:R}, expected {expected:R}.");
            }
        }
    }

    [Fact]
    public void Exponentials_and_angles_too_small_for_all_digits_are_still_right()
    {
        // exp(-740) and 1e-310 by mpmath; a subnormal number has a last place of 2^-1074.
        Assert.Equal(4.2e-322, Elementary.Exp(-740), 1e-323);
        Assert.Equal(1e-310, Elementary.Atan2(1e-300, 1e10), double.Epsilon);
        Assert.Equal((1e-310, 1e-310, 1e-310), (Elementary.Sin(1e-310), Elementary.Tan(1e-310), Elementary.Asin(1e-310)));
        Assert.Equal(-310 * 2.302585092994046, Elementary.Log(1e-310), 1e-12);
        Assert.Equal(1e-155, Elementary.Pow(1e-310, 0.5), 1e-165);
    }

    [Fact]
    public void Sine_and_cosine_are_a_point_of_the_unit_circle() => Draw.Law(Number, x =>
    {
        var (sine, cosine) = Elementary.SinCos(x);
        return (sine, cosine) == (Elementary.Sin(x), Elementary.Cos(x))
            && Math.Abs((sine * sine) + (cosine * cosine) - 1) < 4e-16
            && Elementary.SinCos(-x) == (-sine, cosine)
            && Elementary.Tan(-x) == -Elementary.Tan(x);
    });

    [Fact]
    public void Arc_functions_undo_sine_cosine_and_tangent() => Draw.Law(Number, x =>
    {
        var angle = Math.IEEERemainder(x, 3);
        return Math.Abs(Elementary.Atan(Elementary.Tan(angle)) - angle) <= 4e-16
            && Math.Abs(Elementary.Atan2(7 * Elementary.Sin(angle), 7 * Elementary.Cos(angle)) - angle) <= 4e-16
            && Elementary.Atan(-x) == -Elementary.Atan(x)
            && Math.Abs(Elementary.Sin(Elementary.Asin(angle / 2)) - (angle / 2)) <= 4e-16
            && Math.Abs(Elementary.Asin(angle / 2) + Elementary.Acos(angle / 2) - (Math.PI / 2)) <= 5e-16;
    });

    [Fact]
    public void Logarithm_undoes_the_exponential_and_turns_products_into_sums() => Draw.Law(Number.Two(), n =>
    {
        var (x, y) = (Math.IEEERemainder(n.Item1, 300), Math.Abs(n.Item2) + 1e-9);
        return Math.Abs(Elementary.Log(Elementary.Exp(x)) - x) <= 2.3e-16 * (1 + Math.Abs(x))
            && Math.Abs(Elementary.Log(y * 3) - Elementary.Log(y) - Elementary.Log(3)) <= 1e-14
            && Math.Abs((Elementary.Pow(y, x / 50) / Elementary.Exp(x / 50 * Elementary.Log(y))) - 1) <= 1e-13;
    });

    // An error of 0.51 units allows the next number to have a result one unit lower.
    [Fact]
    public void A_larger_argument_gives_no_result_that_is_lower_by_more_than_a_unit() => Draw.Law(Number, x =>
    {
        var (size, angle, share) = (Math.Abs(x) + 1e-9, Math.IEEERemainder(x, Math.PI), Math.IEEERemainder(x, 1));
        return Rises(Elementary.Exp, Math.IEEERemainder(x, 700))
            && Rises(Elementary.Log, size)
            && Rises(Elementary.Log10, size)
            && Rises(Elementary.Atan, x)
            && Rises(Elementary.Asin, share)
            && Rises(Elementary.Tan, angle / 2.001)
            && Rises(Elementary.Sin, angle / 2.001)
            && Rises(s => Elementary.Pow(s, 1.7), size);
    });

    // The value was calculated here. It says nothing but that this system and processor give what the others gave.
    [Fact]
    public void A_million_results_are_the_same_on_every_system()
    {
        var (state, hash) = (1UL, 14695981039346656037UL);
        foreach (var function in Functions.Values)
        {
            for (var i = 0; i < 91_000; i++)
            {
                state = (state * 6364136223846793005UL) + 1442695040888963407UL;
                var x = ((long)state >> 11) * Math.ScaleB(1, (int)(state & 15) - 54);
                var y = ((int)(state >> 7) + 0.5) * Math.ScaleB(1, -28);
                hash = (hash ^ BitConverter.DoubleToUInt64Bits(function(x, y))) * 1099511628211UL;
            }
        }

        Assert.Equal(14997545129504032204UL, hash);
    }

    private static bool Rises(Func<double, double> function, double x) =>
        function(Math.BitIncrement(x)) >= Math.BitDecrement(function(x));

    private static double Judge(string name, double x, double y) => name switch
    {
        "Exp" => Math.Exp(x),
        "Log" => Math.Log(x),
        "Log10" => Math.Log10(x),
        "Pow" => Math.Pow(x, y),
        "Sin" => Math.Sin(x),
        "Cos" => Math.Cos(x),
        "Tan" => Math.Tan(x),
        "Asin" => Math.Asin(x),
        "Acos" => Math.Acos(x),
        "Atan" => Math.Atan(x),
        _ => Math.Atan2(x, y),
    };
}
