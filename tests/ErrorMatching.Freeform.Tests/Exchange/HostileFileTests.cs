using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Broken and hostile files end in a named error or in a surface, never in anything else.</summary>
public sealed class HostileFileTests
{
    private const int Mutations = 400;

    public static TheoryData<string> Files => ["one.igs", "limited.igs", "one.stp", "limited.stp", "hand.igs", "hand.stp", "grid.csv"];

    [Theory]
    [MemberData(nameof(Files))]
    public void A_damaged_file_is_read_or_refused(string name)
    {
        var file = Of(name);
        var random = new Random(1);
        var refused = 0;
        for (var n = 0; n < Mutations; n++)
        {
            refused += IsRefused(Damaged.Of(file, random), name) ? 1 : 0;
        }

        Assert.InRange(refused, Mutations / 10, Mutations);
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void A_file_that_is_cut_off_is_read_or_refused(string name)
    {
        var file = Of(name);
        for (var length = 0; length < file.Length; length += 1 + (file.Length / 150))
        {
            IsRefused(file[..length], name);
        }
    }

    [Theory]
    [InlineData("")]
    [InlineData("\n\n\n")]
    [InlineData("ISO-10303-21;")]
    [InlineData("i,j,x,y,z\n1,1,0,0,0\n")]
    [InlineData("\u0000\u0001\u0002")]
    public void A_file_of_something_else_is_refused(string text)
    {
        Assert.True(IsRefused(Encoding.Latin1.GetBytes(text), "a.igs"));
        Assert.True(IsRefused(Encoding.Latin1.GetBytes(text), "a.stp"));
    }

    [Fact]
    public void A_file_larger_than_any_surface_is_refused()
    {
        var error = Assert.Throws<InputException>(() => SurfaceReader.Read(
            new byte[SurfaceReader.MaxBytes + 1], "a.igs", null, outsideIsUp: true));
        Assert.Equal("too-large", error.Code);
        Assert.Contains("67108865 bytes; at most 67108864", error.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Matrices_that_refer_to_one_another_are_refused()
    {
        var file = new IgesText();
        file.Add(124, "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,7.", matrix: 3);
        file.Add(124, "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,7.", matrix: 1);
        file.Add(128, IgesText.Flat(3, 2), matrix: 1);
        Assert.Equal("too-deep", Assert.Throws<InputException>(() => file.Read()).Code);
    }

    [Fact]
    public void Curves_that_refer_to_one_another_are_refused()
    {
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 60), dependent: true);
        var boundary = file.Add(142, "142,0,1,7,0,1", dependent: true);
        file.Add(144, $"144,{surface},1,0,{boundary}");
        file.Add(102, "102,2,7,7", dependent: true);
        Assert.Equal("too-deep", Assert.Throws<InputException>(() => file.Read()).Code);
    }

    [Fact]
    public void Curves_that_multiply_are_refused()
    {
        // Each chain has the one before it a hundred times: ten to the power of twelve lines.
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 60), dependent: true);
        var chain = file.Add(110, "110,0.,0.,0.,0.,0.,0.", dependent: true);
        for (var level = 0; level < 6; level++)
        {
            chain = file.Add(102, "102,100" + string.Concat(Enumerable.Repeat($",{chain}", 100)), dependent: true);
        }

        var boundary = file.Add(142, $"142,0,{surface},{chain},0,1", dependent: true);
        file.Add(144, $"144,{surface},1,0,{boundary}");
        Assert.Equal("too-deep", Assert.Throws<InputException>(() => file.Read()).Code);
    }

    [Fact]
    public void Counts_that_the_file_does_not_have_are_refused_before_memory_is_taken()
    {
        var file = new IgesText();
        file.Add(128, "128,2000000,2000000,1,1,0,0,1,0,0,0.,0.,1.,1.");
        Assert.Equal("short-record", Assert.Throws<InputException>(() => file.Read()).Code);
    }

    [Fact]
    public void Lists_nested_without_end_are_refused()
    {
        var data = "#100=B_SPLINE_SURFACE_WITH_KNOTS(" + new string('(', 100_000) + new string(')', 100_000) + ");";
        var error = Assert.Throws<InputException>(() => StepByHand.Read(StepByHand.File("#100", data)));
        Assert.Contains("nested deeper", error.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Shells_that_refer_to_one_another_have_no_face()
    {
        var error = Assert.Throws<InputException>(() => StepByHand.Read(StepByHand.File(
            "#100", "#100=OPEN_SHELL('',(#101));\n#101=OPEN_SHELL('',(#100,#101));")));
        Assert.Equal("no-surface", error.Code);
    }

    [Fact]
    public void Shells_in_shells_without_end_are_refused()
    {
        var data = string.Join(
            '\n', Enumerable.Range(100, 5000).Select(n => string.Create(CultureInfo.InvariantCulture, $"#{n}=OPEN_SHELL('',(#{n + 1}));")));
        Assert.Equal(
            "too-deep",
            Assert.Throws<InputException>(() => StepByHand.Read(StepByHand.File("#100", data + "\n#5100=OPEN_SHELL('',());"))).Code);
    }

    [Fact]
    public void Units_that_refer_to_one_another_are_refused()
    {
        var unit = "(CONVERSION_BASED_UNIT('INCH',#4)LENGTH_UNIT()NAMED_UNIT(*));\n#4=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#2)";
        var data = StepByHand.Points(101, "0.,0.,0.", "0.,1.,0.", "1.,0.,0.", "1.,1.,0.")
            + "\n#100=BEZIER_SURFACE('',1,1,((#101,#102),(#103,#104)),.UNSPECIFIED.,.F.,.F.,.F.);";
        Assert.Equal("bad-unit", Assert.Throws<InputException>(() => StepByHand.Read(StepByHand.File("#100", data, unit))).Code);
        Assert.Equal(1, StepByHand.Read(StepByHand.File("#100", data)).Spline.PointAt(1, 1).X);
    }

    private static byte[] Of(string name)
    {
        var surface = name.StartsWith("one", StringComparison.Ordinal) ? PaperDesign.Three : SurfaceSamples.Of(5, limited: true);
        if (name == "hand.igs")
        {
            var file = new IgesText();
            var basis = file.Add(128, IgesText.Flat(6, 4), dependent: true);
            var hole = file.Add(
                100, "100,0.,3.,2.,4.,2.,4.,2.", dependent: true, matrix: file.Add(124, "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0."));
            file.Add(144, $"144,{basis},0,1,0,{file.Add(142, $"142,0,{basis},0,{hole},2", dependent: true)}");
            return file.Bytes();
        }

        if (name == "grid.csv")
        {
            return Encoding.ASCII.GetBytes(
                "i,j,x,y,z\n"
                    + string.Concat(
                        Enumerable.Range(0, 20).Select(k => string.Create(
                            CultureInfo.InvariantCulture,
                            $"{k % 5},{k / 5},{10 * (k % 5)},{8 * (k / 5)},{7 + (0.1 * (k % 5) * (k / 5))}\n"))));
        }

        if (name == "hand.stp")
        {
            return StepByHand.File("#304", $"""
                {StepByHand.Points(101, "0.,0.,7.", "60.,0.,7.", "60.,40.,7.")}
                {StepByHand.Line(200, 101, 102)}
                {StepByHand.Line(210, 102, 103, forward: false)}
                {StepByHand.Line(220, 103, 101)}
                #9999=DIRECTION('',(1.,0.,0.));
                #300=EDGE_LOOP('',(#200,#210,#220));
                #301=FACE_OUTER_BOUND('',#300,.T.);
                #302=PLANE('',#303);
                #303=AXIS2_PLACEMENT_3D('',#101,$,$);
                #304=ADVANCED_FACE('SHELF',(#301),#302,.T.);
                """);
        }

        return name.EndsWith(".igs", StringComparison.Ordinal) ? IgesWriter.Write(surface) : StepWriter.Write(surface);
    }

    private static bool IsRefused(byte[] bytes, string name)
    {
        try
        {
            return SurfaceReader.Read(bytes, name, entity: null, outsideIsUp: true) is null;
        }
        catch (InputException e)
        {
            Assert.NotEmpty(e.Problem);
            Assert.NotEmpty(e.Code);
            return true;
        }
        catch (Exception e)
        {
            throw new InvalidOperationException($"{e.GetType().Name} from:\n{Encoding.Latin1.GetString(bytes)}", e);
        }
    }
}
