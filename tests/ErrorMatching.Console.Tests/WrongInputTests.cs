using System.Globalization;
using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What a new user gives by mistake is named as what it is, in one message, with what to do.</summary>
public sealed class WrongInputTests
{
    private static readonly string Folder = Repository.PathTo("samples", "complex-mating");
    private static readonly string Job = Path.Combine(Folder, "job.json");
    private static readonly string Program = File.ReadAllText(Path.Combine(Folder, "counterpart.nc"));

    public static TheoryData<string, string, string> NoPrograms => new()
    {
        { "utf-16", "program-not-text", "UTF-16" },
        { "utf-16BE", "program-not-text", "UTF-16" },
        { "utf-16 without a mark", "program-not-text", "UTF-16" },
        { "utf-32", "program-not-text", "UTF-32" },
        { "empty", "empty-program", "an empty file" },
        { "blank", "empty-program", "a file without a block" },
        { "tape leader", "empty-program", "a file without a block" },
        { "PDF", "program-not-text", "a PDF document" },
        { "archive", "program-not-text", "a binary file" },
    };

    [Theory]
    [MemberData(nameof(NoPrograms))]
    public void What_is_no_program_is_named_before_anything_is_looked_for_in_it(string kind, string code, string found)
    {
        using var folder = new TemporaryFolder();
        var file = Path.Combine(folder.Path, "p.nc");
        File.WriteAllBytes(file, kind switch
        {
            "utf-16" => [0xFF, 0xFE, .. Encoding.Unicode.GetBytes(Program)],
            "utf-16BE" => [0xFE, 0xFF, .. Encoding.BigEndianUnicode.GetBytes(Program)],
            "utf-16 without a mark" => Encoding.Unicode.GetBytes(Program),
            "utf-32" => [0xFF, 0xFE, 0, 0, .. Encoding.UTF32.GetBytes(Program)],
            "blank" => "\uFEFF\r\n \t\n"u8.ToArray(),
            "tape leader" => new byte[100],
            "PDF" => "%PDF-1.7\n1 0 obj\n"u8.ToArray(),
            "archive" => [.. Enumerable.Range(0, 3000).Select(i => (byte)((i * 7919) >> 3))],
            _ => [],
        });
        foreach (var line in (string[][])[["nc", "check", file], ["nc", "motion", file], ["match", Job, "--program", file]])
        {
            var error = Shell.Error(1, line);
            Assert.Equal((code, file), (error.Text("code"), error.Text("file")));
            Assert.Contains(found, error.Text("message")!, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void What_a_control_reads_is_a_program()
    {
        foreach (var text in (string[])["%\n", "G0 X1\n", "\0\0\0\0%\nO1\nG0 X1\nM30\n%\0\0", "N10 G0 X1 (\u00e4\u00f6)",
            "\u0012%\nG0\n\u0014"])
        {
            Assert.Null(ProgramContent.Problem(Encoding.Latin1.GetBytes(text)));
        }
    }

    [Theory]
    [InlineData("match", "@")]
    [InlineData("match", "JOB --part @")]
    [InlineData("match", "JOB --program @")]
    [InlineData("nc", "check @")]
    [InlineData("nc", "diff @ @")]
    [InlineData("nc", "prove PROGRAM PROGRAM --wish @")]
    [InlineData("surface", "plan @")]
    [InlineData("surface", "fit @")]
    [InlineData("fit", "line @")]
    [InlineData("job", "check @")]
    [InlineData("cell", "check @")]
    [InlineData("nc", "check PROGRAM --dialect @/d.json")]
    public void A_folder_given_as_a_file_is_called_a_folder(string verb, string rest)
    {
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(Path.Combine(folder.Path, "d.json"));
        var message = Shell.Error(1, [verb, .. rest.Split(' ').Select(w => w.Replace("@", folder.Path, StringComparison.Ordinal)
            .Replace("JOB", Job, StringComparison.Ordinal)
            .Replace("PROGRAM", Path.Combine(Folder, "counterpart.nc"), StringComparison.Ordinal))]).Text("message")!;
        Assert.Contains("a folder", message, StringComparison.Ordinal);
        Assert.DoesNotContain("denied", message, StringComparison.OrdinalIgnoreCase);
        Assert.DoesNotContain("find", message, StringComparison.OrdinalIgnoreCase);
    }

    [Theory]
    [InlineData("fanuk", "\"fanuc\"")]
    [InlineData("siemens", "\"siemens-840d\"")]
    [InlineData("Heidenhain", "\"heidenhain-klartext\"")]
    public void A_misspelled_dialect_of_a_job_has_its_place_and_the_name_that_was_meant(string name, string meant)
    {
        using var folder = new TemporaryFolder();
        var job = folder.File("job.json", File.ReadAllText(Job).Replace("delta-nc300", name, StringComparison.Ordinal));
        foreach (var line in (string[][])[["job", "check", job], ["match", job]])
        {
            var error = Shell.Error(1, line);
            Assert.Equal(("unknown-dialect", job, "$.counterpart.dialect"), (error.Text("code"), error.Text("file"), error.Text("path")));
            Assert.Equal((18, 16), (error.Number("line"), error.Number("column")));
            Assert.Contains($"expected {meant}, or one of", error.Text("message")!, StringComparison.Ordinal);
        }

        Assert.Contains($"Did you mean {meant.Trim('"')}?", Shell.Error(1, "nc", "check", Job, "--dialect", name).Text("message")!,
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("klartext-mating", "counterpart.h", "fanuc", "heidenhain-klartext")]
    [InlineData("complex-mating", "counterpart.nc", "heidenhain-klartext", "generic")]
    public void Most_blocks_that_are_not_understood_are_told_first_with_the_dialect_that_knows_them(
        string sample, string name, string dialect, string better)
    {
        var program = Repository.PathTo("samples", sample, name);
        var (_, output, _) = Shell.Run("nc", "check", program, "--dialect", dialect);
        var first = output.Split('\n')[2];
        Assert.Contains($"have words that the dialect {dialect} does not know", first, StringComparison.Ordinal);
        Assert.Contains(better, first, StringComparison.Ordinal);
        Assert.Equal(
            better,
            Shell.Json(0, "errormatch/nc-check/1", "nc", "check", program, "--dialect", dialect).GetProperty("understanding")
                .Text("betterDialect"));

        var errors = Shell.Json(2, "errormatch/error/1", "nc", "locate", program, "--dialect", dialect, "--blocks", "N99999")
            .GetProperty("errors");
        Assert.Equal("wrong-dialect", errors[0].Text("code"));
        Assert.Equal("block-not-found", errors[1].Text("code"));
    }

    [Fact]
    public void A_match_in_another_dialect_says_so_first()
    {
        var errors = Shell.Json(
            2, "errormatch/error/1", "match", Job, "--program", Repository.PathTo("samples", "klartext-mating", "counterpart.h"))
            .GetProperty("errors");
        Assert.Equal("wrong-dialect", errors[0].Text("code"));
        Assert.Contains("heidenhain-klartext", errors[0].Text("message")!, StringComparison.Ordinal);
    }

    [Fact]
    public void A_dialect_that_knows_most_blocks_is_not_doubted()
    {
        foreach (var dialect in NcDialects.All.Where(d => d.Syntax != NcSyntax.Klartext))
        {
            Assert.True(
                DialectFit.Of(NcProgram.Read(File.ReadAllBytes(Path.Combine(Folder, "counterpart.nc")), dialect.Syntax), dialect) is null,
                dialect.Name);
        }
    }

    [Theory]
    [InlineData("y,x", "y, x")]
    [InlineData("-x,y", "-x, y")]
    [InlineData("x,-y", "x, -y")]
    [InlineData("-y,x", "y, -x")]
    public void Exchanged_columns_and_reversed_axes_are_named_in_one_message(string written, string read)
    {
        using var folder = new TemporaryFolder();
        var part = Written(folder, "part.csv", written);
        var error = Shell.Error(2, "match", Job, "--part", part);
        Assert.Equal(("columns-differ", part), (error.Text("code"), error.Text("file")));
        Assert.Contains($"read as {read}:", error.Text("message")!, StringComparison.Ordinal);
    }

    // With an alignment, a piece may lie anywhere: what exchanged columns show is a mirrored one.
    [Theory]
    [InlineData("y,x", true)]
    [InlineData("-x,y", true)]
    [InlineData("x,y", false)]
    [InlineData("-y,x", false)]
    public void Exchanged_columns_are_named_in_a_job_with_an_alignment(string written, bool isMirrored)
    {
        using var folder = new TemporaryFolder();
        var part = Written(folder, "part.csv", written);
        var job = Aligned(folder);
        if (isMirrored)
        {
            var error = Shell.Error(2, "match", job, "--part", part);
            Assert.Equal(("columns-differ", part), (error.Text("code"), error.Text("file")));
            Assert.Contains("read as y, x:", error.Text("message")!, StringComparison.Ordinal);
        }
        else
        {
            var (exit, _, message) = Shell.Run("match", job, "--part", part);
            Assert.Equal((0, ""), (exit, message));
        }
    }

    [Theory]
    [InlineData("--part", false)]
    [InlineData("--before", false)]
    [InlineData("--after", false)]
    [InlineData("--part", true)]
    [InlineData("--before", true)]
    [InlineData("--after", true)]
    public void Verify_names_exchanged_columns_of_each_measurement(string option, bool isAligned)
    {
        using var folder = new TemporaryFolder();
        var files = new Dictionary<string, string>(StringComparer.Ordinal)
        {
            ["--part"] = "part.csv",
            ["--before"] = "counterpart.csv",
            ["--after"] = "counterpart-after.csv",
        };
        string[] line = ["verify", isAligned ? Aligned(folder) : Job,
            .. files.SelectMany(f => new[] { f.Key, f.Key == option ? Written(folder, f.Value, "y,x") : Path.Combine(Folder, f.Value) })];
        var error = Shell.Error(2, line);
        Assert.Equal(("columns-differ", folder[files[option]]), (error.Text("code"), error.Text("file")));
        Assert.Contains("read as y, x:", error.Text("message")!, StringComparison.Ordinal);
    }

    [Fact]
    public void Control_characters_are_shown()
    {
        Assert.Contains("pa\\trt.csv: found no such file", Shell.Run("match", Job, "--part", "pa\trt.csv").Error, StringComparison.Ordinal);
        using var folder = new TemporaryFolder();
        var job = folder.File(
            "job.json", File.ReadAllText(Job).Replace("\"points\", \"unc", "{ \"delimiter\": \"\\t \" }, \"unc", StringComparison.Ordinal));
        Assert.Contains(
            "found the text \"\\t \"; expected one of \",\", \";\"", Shell.Run("job", "check", job).Error,
            StringComparison.Ordinal);
        var program = folder.File("p.nc", "N10 G0 X1 \u001b Y2\n");
        Assert.Contains("\\u001b", Shell.Run("nc", "check", program).Output, StringComparison.Ordinal);
        Assert.DoesNotContain('\u001b', Shell.Run("nc", "check", program).Output);
    }

    [Fact]
    public void A_surface_measured_on_a_grid_of_its_own_is_called_that()
    {
        var job = Repository.PathTo("samples", "surface-one", "job.json");
        var points = File.ReadAllLines(Repository.PathTo("samples", "surface-one", "measured.csv")).Skip(1)
            .Select(l => l.Split(',').Skip(1).Select(c => double.Parse(c, CultureInfo.InvariantCulture)).ToArray()).ToArray();
        using var folder = new TemporaryFolder();

        // Between the points of each of the seven curves; the same points from the other end; and numbered by their places on 7 by 10.
        var between = Enumerable.Range(0, 70).Where(k => k % 10 < 9)
            .Select(k => points[k].Zip(points[k + 1], (a, b) => (a + b) / 2).ToArray()).ToArray();
        foreach (var (own, why) in ((double[][], string)[])[
            (between, "a grid of its own"), ([.. points.Reverse()], "an order of its own")])
        {
            var file = folder.File("own.csv", "point,x,y,z\n" + string.Concat(own.Select((p, k) => string.Create(
                CultureInfo.InvariantCulture, $"{k + 1},{p[0]:0.0000},{p[1]:0.0000},{p[2]:0.0000}\n"))));
            var error = Shell.Error(1, "surface", "evaluate", job, "--measured", file);
            Assert.Equal(("own-grid", file), (error.Text("code"), error.Text("file")));
            Assert.Contains(why, error.Text("message")!, StringComparison.Ordinal);
        }

        var swapped = folder.File("swapped.csv", "point,y,x,z\n" + string.Concat(points.Select((p, k) => string.Create(
            CultureInfo.InvariantCulture, $"{k + 1},{p[0]:0.0000},{p[1]:0.0000},{p[2]:0.0000}\n"))));
        Assert.Contains(
            "Read as y, x, z,", Shell.Error(1, "surface", "evaluate", job, "--measured", swapped).Text("message")!,
            StringComparison.Ordinal);
    }

    // The sample's job with an alignment, next to copies of its files.
    private static string Aligned(TemporaryFolder folder)
    {
        folder.File("theoretical.csv", File.ReadAllText(Path.Combine(Folder, "theoretical.csv")));
        folder.File("counterpart.nc", Program);
        if (!File.Exists(folder["counterpart.csv"]))
            folder.File("counterpart.csv", File.ReadAllText(Path.Combine(Folder, "counterpart.csv")));
        return folder.File("job.json", File.ReadAllText(Job).Replace(
            "\"alignment\": { \"kind\": \"none\" }", "\"alignment\": { \"kind\": \"best-fit\" }", StringComparison.Ordinal));
    }

    // One of the sample's measurements with other columns in the places of x and y.
    private static string Written(TemporaryFolder folder, string name, string written)
    {
        var lines = File.ReadAllLines(Path.Combine(Folder, name)).Skip(1).Select(l => l.Split(',')).Select(c =>
        {
            string Of(string axis) => axis switch
            {
                "x" => c[1],
                "y" => c[2],
                _ => (-double.Parse(c[axis == "-x" ? 1 : 2], CultureInfo.InvariantCulture)).ToString(CultureInfo.InvariantCulture),
            };
            var axes = written.Split(',');
            return $"{c[0]},{Of(axes[0])},{Of(axes[1])}";
        });
        return folder.File(name, "point,x_mm,y_mm\n" + string.Join('\n', lines) + "\n");
    }
}
