using System.Globalization;
using System.Text;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>What programs compute: expected values are closed forms or hand-computed;
/// those of LinuxCNC are what rs274 of LinuxCNC 2.9 gives.</summary>
public sealed class ExpressionTests
{
    [Theory]
    [InlineData("1+2*3-8/4", 5)]
    [InlineData("[1+2]*3", 9)]
    [InlineData("10-4-3", 3)]
    [InlineData("-2*-3", 6)]
    [InlineData("--2", 2)]
    [InlineData("+.5", 0.5)]
    [InlineData("7MOD3", 1)]
    [InlineData("-7 MOD 3", -1)]
    [InlineData("7.4MOD2.6", 1)]
    [InlineData("12AND10", 8)]
    [InlineData("12OR10", 14)]
    [InlineData("12XOR10", 6)]
    [InlineData("1OR2AND4", 1)] // AND ranks with *, OR with +
    [InlineData("2+6AND3", 4)]
    [InlineData("2 EQ 2", 1)]
    [InlineData("2 NE 2", 0)]
    [InlineData("3GT2", 1)]
    [InlineData("3LT2", 0)]
    [InlineData("2GE2", 1)]
    [InlineData("3LE2", 0)]
    [InlineData("1+1 EQ 4/2", 1)]
    [InlineData("SIN[30]", 0.5)]
    [InlineData("SIN[-90]", -1)]
    [InlineData("SIN[180]", 0)]
    [InlineData("COS[60]", 0.5)]
    [InlineData("COS[90]", 0)]
    [InlineData("TAN[45]", 1)]
    [InlineData("ASIN[.5]", 30)]
    [InlineData("ASIN[-.5]", 330)]
    [InlineData("ACOS[-1]", 180)]
    [InlineData("ATAN[1]", 45)]
    [InlineData("ATAN[-1]", -45)]
    [InlineData("ATAN[1]/[-1]", 135)]
    [InlineData("ATAN[-1]/[-1]", 225)]
    [InlineData("ATAN[-1,-1]", 225)]
    [InlineData("ATAN[1]/3", 15)]
    [InlineData("SQRT[2.25]", 1.5)]
    [InlineData("SQR[9]", 3)]
    [InlineData("ABS[-3]", 3)]
    [InlineData("ROUND[2.5]", 3)]
    [InlineData("RND[-2.5]", -3)]
    [InlineData("FIX[-2.7]", -2)]
    [InlineData("FIX[2.7]", 2)]
    [InlineData("FUP[2.1]", 3)]
    [InlineData("FUP[-2.1]", -3)]
    [InlineData("LN[EXP[2]]", 2)]
    [InlineData("POW[2,10]", 1024)]
    [InlineData("POW[-2,3]", -8)]
    [InlineData("BCD[25]", 37)] // 0x25
    [InlineData("BIN[37]", 25)]
    [InlineData("ADP[3]", 3)]
    [InlineData("sin[ 30 ] * 2", 1)]
    public void Fanuc_computes(string text, double expected) => Computes(NcSyntax.Iso, text, expected);

    [Theory]
    [InlineData("2**3**2", 64)]
    [InlineData("-2**2", 4)]
    [InlineData("2*3**2", 18)]
    [InlineData("7 mod -3", 1)]
    [InlineData("-7 mod 3", 2)]
    [InlineData("1 EQ 1.000001", 1)]
    [InlineData("1 EQ 1.0001", 0)]
    [InlineData("1 NE 1.000001", 0)]
    [InlineData("1 LE 0.999999", 0)]
    [InlineData("1 + 2 * 3 - 8 / 4", 5)]
    [InlineData("1 LT 2 AND 0", 0)]
    [InlineData("1 OR 0 AND 0", 0)] // one rank, left to right
    [InlineData("2 - 3 LT 0", 1)]
    [InlineData("2 EQ 2 EQ 1", 1)]
    [InlineData("5 xor 0", 1)]
    [InlineData("3 and 4", 1)]
    [InlineData("fix[-2.5]", -3)]
    [InlineData("fup[-2.5]", -2)]
    [InlineData("round[-2.5]", -3)]
    [InlineData("round[2.5]", 3)]
    [InlineData("atan[-1]/[0]", -90)]
    [InlineData("atan[1]/[-1]", 135)]
    [InlineData("asin[-.5]", -30)]
    [InlineData("acos[.5]", 60)]
    [InlineData("tan[-45]", -1)]
    [InlineData("cos[120]", -0.5)]
    [InlineData("sqrt[16]", 4)]
    [InlineData("abs[-1.5]", 1.5)]
    [InlineData("ln[exp[3]]", 3)]
    [InlineData("-sin[30]", -0.5)]
    [InlineData("1 2", 12)]
    [InlineData("exists[#<foo>]", 0)]
    [InlineData("exists[#<_x>]", 1)]
    [InlineData("#31+#30", 0)]
    public void LinuxCnc_computes(string text, double expected) => Computes(NcSyntax.LinuxCnc, text, expected);

    [Theory]
    [InlineData("1+2*3-8/4", 5)]
    [InlineData("(1+2)*3", 9)]
    [InlineData("3/4", 0.75)]
    [InlineData("7 DIV 2", 3)]
    [InlineData("-7 DIV 2", -3)]
    [InlineData("7 MOD 4", 3)]
    [InlineData("12 B_AND 10", 8)]
    [InlineData("12 B_OR 10", 14)]
    [InlineData("12 B_XOR 10", 6)]
    [InlineData("B_NOT 0", -1)]
    [InlineData("1 B_OR 2 B_AND 4", 1)]
    [InlineData("1+1 B_AND 2", 2)]
    [InlineData("TRUE OR TRUE XOR TRUE", 1)] // XOR first
    [InlineData("TRUE OR FALSE AND FALSE", 1)] // AND first
    [InlineData("NOT TRUE", 0)]
    [InlineData("NOT (1 > 2)", 1)]
    [InlineData("(1==1) AND (2<>3)", 1)]
    [InlineData("3 == 1 AND 2", 0)] // comparisons rank lowest
    [InlineData("1 >= 1", 1)]
    [InlineData("1 <= 0", 0)]
    [InlineData("1 < 2", 1)]
    [InlineData("1 > 2", 0)]
    [InlineData("0.1+0.2 == 0.3", 1)] // equal within 1e-12
    [InlineData("0.1+0.2 > 0.3", 0)]
    [InlineData("SIN(30)", 0.5)]
    [InlineData("COS(180)", -1)]
    [InlineData("TAN(135)", -1)]
    [InlineData("ASIN(-.5)", -30)]
    [InlineData("ACOS(0)", 90)]
    [InlineData("ATAN2(1,-1)", 135)]
    [InlineData("ATAN2(-1,-1)", -135)]
    [InlineData("SQRT(2.25)", 1.5)]
    [InlineData("ABS(-2)", 2)]
    [InlineData("POT(-3)", 9)]
    [InlineData("TRUNC(-2.7)", -2)]
    [InlineData("ROUND(2.5)", 3)]
    [InlineData("LN(EXP(2))", 2)]
    [InlineData("MINVAL(3,-4)", -4)]
    [InlineData("MAXVAL(3,-4)", 3)]
    [InlineData("BOUND(0,10,12)", 10)]
    [InlineData("1.5EX3", 1500)]
    [InlineData("15EX-1", 1.5)]
    [InlineData("'H1F'", 31)]
    [InlineData("'B101'", 5)]
    [InlineData("\"a\"<<\"b\" == \"AB\"", 1)]
    [InlineData("\"A\" == 1", 0)]
    public void Siemens_computes(string text, double expected) => Computes(NcSyntax.Siemens, text, expected);

    [Theory]
    [InlineData(NcSyntax.Iso, "1/0", 2, "division by zero")]
    [InlineData(NcSyntax.Iso, "1 MOD .4", 3, "division by zero")]
    [InlineData(NcSyntax.Iso, "SQRT[-1]", 1, "negative")]
    [InlineData(NcSyntax.Iso, "TAN[90]", 1, "tangent")]
    [InlineData(NcSyntax.Iso, "TAN[-450]", 1, "tangent")]
    [InlineData(NcSyntax.Iso, "[1+2", 5, "not closed")]
    [InlineData(NcSyntax.Iso, "SINE[1]", 1, "no function")]
    [InlineData(NcSyntax.Iso, "1+", 3, "missing")]
    [InlineData(NcSyntax.Iso, "1.2.3", 1, "two points")]
    [InlineData(NcSyntax.Iso, "POW[2]", 1, "2 arguments")]
    [InlineData(NcSyntax.Iso, "SIN[1,2]", 7, "no further")]
    [InlineData(NcSyntax.Iso, "BIN[10]", 1, "binary-coded")]
    [InlineData(NcSyntax.Iso, "LN[0]", 1, "logarithm")]
    [InlineData(NcSyntax.Iso, "EXP[1000]", 1, "too large")]
    [InlineData(NcSyntax.Iso, "ASIN[1.1]", 1, "arc sine")]
    [InlineData(NcSyntax.Iso, "#34", 1, "no variable #34")]
    [InlineData(NcSyntax.Iso, "#[1/2]", 2, "whole number")]
    [InlineData(NcSyntax.Iso, "#", 2, "number of a variable")]
    [InlineData(NcSyntax.LinuxCnc, "[-8]**[1/3]", 5, "power")]
    [InlineData(NcSyntax.LinuxCnc, "#<nowhere>", 1, "never been assigned")]
    [InlineData(NcSyntax.LinuxCnc, "#<nowhere", 2, "not closed")]
    [InlineData(NcSyntax.LinuxCnc, "atan[1]", 1, "2 arguments")]
    [InlineData(NcSyntax.Siemens, "(1+2", 5, "not closed")]
    [InlineData(NcSyntax.Siemens, "7 DIV 0", 3, "division by zero")]
    [InlineData(NcSyntax.Siemens, "\"a\" + 1", 5, "text")]
    [InlineData(NcSyntax.Siemens, "\"a", 1, "not closed")]
    [InlineData(NcSyntax.Siemens, "BOUND(2,1,0)", 1, "bounds")]
    [InlineData(NcSyntax.Siemens, "'HG'", 1, "no number")]
    public void What_has_no_value_is_an_error_with_its_column(NcSyntax syntax, string text, int column, string why)
    {
        Read(syntax, text, new(syntax), out var error, out var at);
        Assert.Contains(why, error, StringComparison.Ordinal);
        Assert.Equal(column, at + 1);
    }

    [Theory]
    [InlineData(NcSyntax.Iso, "#5041")]
    [InlineData(NcSyntax.Iso, "#100")]
    [InlineData(NcSyntax.Iso, "#500*0")]
    [InlineData(NcSyntax.Iso, "SIN[#3012]+1")]
    [InlineData(NcSyntax.Iso, "#[#1000]")]
    [InlineData(NcSyntax.LinuxCnc, "#5420+1")]
    [InlineData(NcSyntax.LinuxCnc, "#5221")]
    [InlineData(NcSyntax.LinuxCnc, "#<_x>")]
    [InlineData(NcSyntax.LinuxCnc, "#<_hal[spindle.0.speed]>")]
    [InlineData(NcSyntax.Siemens, "R1")]
    [InlineData(NcSyntax.Siemens, "$AA_IW[X]+1")]
    [InlineData(NcSyntax.Siemens, "$P_UIFR[1,X,TR]")]
    [InlineData(NcSyntax.Siemens, "SOMEWHERE[X,1]*2")]
    [InlineData(NcSyntax.Siemens, "NOT GUD_FLAG")]
    public void What_only_the_machine_knows_is_unknown(NcSyntax syntax, string text)
    {
        Assert.Equal(NcValue.Unknown, Read(syntax, text, new(syntax), out var error, out _));
        Assert.Null(error);
    }

    [Theory]
    [InlineData(NcSyntax.Iso, 5221, "unknown")] // a timer, or an offset that G10 has changed since
    [InlineData(NcSyntax.Iso, 500, "7")]
    [InlineData(NcSyntax.LinuxCnc, 5221, "7")]
    [InlineData(NcSyntax.Siemens, 1, "7")]
    public void An_assigned_variable_is_known_unless_the_machine_changes_it_by_itself(NcSyntax syntax, int number, string expected)
    {
        var variables = new NcVariables(syntax);
        Assert.Null(variables.Write(VariablePlace.Numbered(number), NcValue.Of(7.0)));
        Assert.Equal(expected, variables.Read(VariablePlace.Numbered(number), out _).ToString());
    }

    [Fact]
    public void What_the_machine_may_have_changed_can_be_forgotten()
    {
        var variables = new NcVariables(NcSyntax.LinuxCnc);
        variables.Write(VariablePlace.Numbered(5221), NcValue.Of(7.0));
        variables.Write(VariablePlace.Numbered(100), NcValue.Of(8.0));
        variables.ForgetMachine();
        Assert.Equal(NcValue.Unknown, variables.Read(VariablePlace.Numbered(5221), out _));
        Assert.Equal(8, variables.Read(VariablePlace.Numbered(100), out _).Number);
    }

    [Theory]
    [InlineData("#1", false)]
    [InlineData("-#1", false)]
    [InlineData("#0", false)]
    [InlineData("#1+#1", true)]
    [InlineData("#1*5", true)]
    [InlineData("SIN[#1]", true)]
    public void A_vacant_variable_is_zero_only_where_it_is_computed_with(string text, bool zero) =>
        Assert.Equal(zero ? NcValue.Zero : NcValue.Vacant, Read(NcSyntax.Iso, text, new(NcSyntax.Iso), out _, out _));

    [Theory]
    [InlineData("#1EQ#0", 1)]
    [InlineData("#1NE#0", 0)]
    [InlineData("#1EQ0", 0)]
    [InlineData("#1NE0", 1)]
    [InlineData("#1GE0", 1)]
    [InlineData("#1GT0", 0)]
    [InlineData("#2EQ#0", 0)]
    public void A_vacant_variable_equals_only_nothing(string text, double expected)
    {
        var variables = new NcVariables(NcSyntax.Iso);
        variables.Write(VariablePlace.Numbered(2), NcValue.Zero);
        Assert.Equal(expected, Read(NcSyntax.Iso, text, variables, out _, out _).Number);
    }

    [Theory]
    [InlineData(NcSyntax.Iso, "#1", 2)]
    [InlineData(NcSyntax.Iso, "##1", 3)]
    [InlineData(NcSyntax.Iso, "###1", 4)]
    [InlineData(NcSyntax.Iso, "#[#1+1]", 4)]
    [InlineData(NcSyntax.Iso, "#[#1]+#1", 5)]
    [InlineData(NcSyntax.LinuxCnc, "##1", 3)]
    [InlineData(NcSyntax.LinuxCnc, "#[#1+1]*2", 8)]
    [InlineData(NcSyntax.LinuxCnc, "#1.00005", 2)]
    [InlineData(NcSyntax.Siemens, "R1", 2)]
    [InlineData(NcSyntax.Siemens, "R[R1]", 3)]
    [InlineData(NcSyntax.Siemens, "R[R1+1]-R1", 2)]
    public void A_variable_can_name_another(NcSyntax syntax, string text, double expected)
    {
        var variables = new NcVariables(syntax);
        for (var i = 1; i <= 3; i++)
        {
            variables.Write(VariablePlace.Numbered(i), NcValue.Of(i + 1.0));
        }

        Assert.Equal(expected, Read(syntax, text, variables, out var error, out _).Number);
        Assert.Null(error);
    }

    [Fact]
    public void Round_in_an_address_of_Fanuc_rounds_to_the_least_increment()
    {
        var syntax = ExpressionSyntax.Of(NcSyntax.Iso);
        var reader = new ExpressionReader("[ROUND[1.2345]+ROUND[2.3456]]"u8, 0, syntax, new(NcSyntax.Iso)) { RoundDecimals = 3 };
        Assert.Equal(1.235 + 2.346, reader.Expression().Number, 12);
    }

    [Theory]
    [InlineData("[", "]")]
    [InlineData("-", "")]
    [InlineData("SIN[", "]")]
    [InlineData("1+[", "]")]
    public void Nesting_has_a_limit(string open, string close)
    {
        string Nested(int depth) => string.Concat(Enumerable.Repeat(open, depth)) + "1" + string.Concat(Enumerable.Repeat(close, depth));
        Read(NcSyntax.Iso, Nested(20), new(NcSyntax.Iso), out var shallow, out _);
        Assert.Null(shallow);
        Read(NcSyntax.Iso, Nested(100_000), new(NcSyntax.Iso), out var deep, out _);
        Assert.Contains("nested", deep, StringComparison.Ordinal);
    }

    [Fact]
    public void Any_bytes_are_read_without_an_exception_and_give_no_NaN()
    {
        var pieces = new[]
        {
            "#",
            "[",
            "]",
            "(",
            ")",
            "<",
            ">",
            "1",
            "2.5",
            ".",
            "-",
            "+",
            "*",
            "/",
            "**",
            "SIN",
            "ATAN",
            "MOD",
            "AND",
            "EQ",
            "NOT ",
            "R1",
            "R[",
            "\"",
            "'H",
            "EX",
            "$P",
            "_",
            ",",
            " ",
            "POW[",
            "0",
            "X",
            "é"
        };
        var soup = Gen.Frequency(
            (4, Gen.Elements(pieces).ArrayOf().Select(p => Encoding.UTF8.GetBytes(string.Concat(p)))),
            (1, Gen.Choose(0, 255).Select(n => (byte)n).ArrayOf()));
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(4000, 20_000)), Prop.ForAll(soup.ToArbitrary(), bytes =>
        {
            foreach (var syntax in Enum.GetValues<NcSyntax>())
            {
                var reader = new ExpressionReader(bytes, 0, ExpressionSyntax.Of(syntax), new(syntax));
                var value = reader.Expression();
                Assert.True(double.IsFinite(value.Number));
                Assert.InRange(reader.At, 0, bytes.Length);
                Assert.True(reader.Error is null || value.IsUnknown);
            }

            return true;
        }));
    }

    private static void Computes(NcSyntax syntax, string text, double expected)
    {
        var value = Read(syntax, text, new(syntax), out var error, out _);
        Assert.Null(error);
        Assert.True(value.IsNumber, value.ToString());
        Assert.Equal(expected, value.Number, 1e-12);
    }

    private static NcValue Read(NcSyntax syntax, string text, NcVariables variables, out string? error, out int at)
    {
        var bytes = Encoding.UTF8.GetBytes(text);
        var reader = new ExpressionReader(bytes, 0, ExpressionSyntax.Of(syntax), variables);
        var value = reader.Expression();
        (error, at) = (reader.Error, reader.ErrorAt);
        Assert.True(
            error is not null || reader.At == bytes.Length,
            string.Create(CultureInfo.InvariantCulture, $"Only {reader.At} bytes were read."));
        return value;
    }
}
