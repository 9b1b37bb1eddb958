using System.Globalization;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Measurements of the other piece, which fit the job as well as those of the right one.</summary>
public sealed class WrongPieceTests
{
    private static readonly string[] Files = ["job.json", "theoretical.csv", "part.csv", "counterpart.nc", "counterpart.csv"];

    [Fact]
    public void The_counterpart_s_file_is_no_measurement_of_the_part()
    {
        using var folder = Copied();
        File.Copy(folder["counterpart.csv"], folder["copy.csv"]);
        foreach (var given in (GivenFile[])[
            new(folder["counterpart.csv"]), new(folder["copy.csv"]), new("sent.csv", File.ReadAllBytes(folder["counterpart.csv"]))])
        {
            var error = Assert.Throws<InputException>(() => new JobFiles(folder["job.json"]).Part(given));
            Assert.Equal(("wrong-piece", given.File, 1), (error.Code, error.File, error.Place.Line));
            Assert.Contains(" counterpart.csv", error.Message, StringComparison.Ordinal);
        }

        File.AppendAllText(folder["copy.csv"], "\n");
        Assert.Equal(folder["copy.csv"], new JobFiles(folder["job.json"]).Part(new(folder["copy.csv"])).File);
    }

    [Fact]
    public void The_part_s_file_is_no_measurement_of_a_counterpart()
    {
        using var folder = Copied();
        var part = new JobFiles(folder["job.json"]).Part(null);
        Assert.Equal(folder["part.csv"], part.File);

        // It matters which part is given, and not what these files have read.
        var files = new JobFiles(folder["job.json"]);
        var copy = new GivenFile("c.csv", File.ReadAllBytes(folder["part.csv"]));
        var error = Assert.Throws<InputException>(() => files.Counterpart(copy, part));
        Assert.Equal(("wrong-piece", "c.csv"), (error.Code, error.File));
        Assert.Equal(folder["counterpart.csv"], files.Counterpart(new(folder["counterpart.csv"]), part).File);
        _ = files.Part(null);
        Assert.Equal("c.csv", files.Counterpart(copy, part: null).File);
    }

    [Fact]
    public void A_counterpart_that_is_not_there_is_no_reason_to_refuse_a_part()
    {
        using var folder = Copied();
        File.Delete(folder["counterpart.csv"]);
        Assert.Equal(folder["part.csv"], new JobFiles(folder["job.json"]).Part(null).File);
    }

    // The part's points as a gauge measures them on the counterpart's place: moved or mirrored by the job's frame.
    [Theory]
    [InlineData("\"translateMm\": [-80, 0]", 1, -80, true)]
    [InlineData("\"mirror\": \"x\"", -1, 0, true)]
    [InlineData("\"translateMm\": [-80, 0]", 1, 80, false)]
    [InlineData("\"translateMm\": [-80, 0]", 1, 0, false)]
    [InlineData("\"translateMm\": [-0.5, 0]", 1, -0.5, false)]
    public void Points_on_the_counterpart_s_frame_are_no_measurement_of_the_part(string frame, int mirror, double by, bool isRefused)
    {
        using var folder = Copied();
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace(
                "\"frame\": { \"mirror\": \"none\", \"rotateDeg\": 0, \"translateMm\": [0, 0] }",
                $"\"frame\": {{ {frame} }}",
                StringComparison.Ordinal));
        var rows = File.ReadLines(folder["part.csv"]).Skip(1).Select(l => l.Split(','));
        File.WriteAllText(
            folder["moved.csv"],
            "point,x_mm,y_mm\n"
                + string.Concat(rows.Select(r => FormattableString.Invariant(
                    $"{r[0]},{(mirror * double.Parse(r[1], CultureInfo.InvariantCulture)) + by},{r[2]}\n"))));
        var files = new JobFiles(folder["job.json"]);
        var (theoretical, part) = (files.Theoretical(), files.Part(new(folder["moved.csv"])));
        var error = Record.Exception(() => files.CheckFrame(theoretical, part)) as InputException;
        Assert.Equal(isRefused ? "wrong-piece" : null, error?.Code);
        Assert.Equal(isRefused, error?.Message.Contains("counterpart.frame", StringComparison.Ordinal) ?? false);
    }

    private static TemporaryFolder Copied()
    {
        var folder = new TemporaryFolder();
        foreach (var file in Files)
        {
            File.Copy(Repository.PathTo("samples", "complex-mating", file), folder[file]);
        }

        return folder;
    }
}
