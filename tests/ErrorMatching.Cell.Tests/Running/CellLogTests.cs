using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed partial class CellLogTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private IReadOnlyList<string> Files => [.. Directory.EnumerateFiles(_folder.Path).Order(StringComparer.Ordinal)];

    [Fact]
    public void Each_line_is_a_document_with_time_level_template_and_properties()
    {
        var before = TimeProvider.System.GetUtcNow();
        var correction = new Correction(7, CorrectionState.Failed, 3, "cmm", "S1 \"\n\u202E.csv", before, new string('a', 64), 5)
        {
            Job = "housing",
            Serial = "S1",
            Machine = "vmc",
            Slot = "A",
            Code = "machine-away",
            Trace = "00-1-2-01"
        };
        using (var log = CellLog.Open(_folder.Path))
        {
            StepLog.Write(log, CorrectionState.Uploading, correction, "no answer");
            log.Debug(new InvalidOperationException("outer\nline"), "{Where} fails", "slot vmc/A");
        }

        var lines = File.ReadAllLines(Assert.Single(Files));
        Assert.Equal(2, lines.Length);
        using var step = JsonDocument.Parse(lines[0]);
        var root = step.RootElement;
        Assert.InRange(root.GetProperty("Timestamp").GetDateTimeOffset(), before, TimeProvider.System.GetUtcNow());
        Assert.Equal("Error", root.GetProperty("Level").GetString());
        Assert.Equal("{Correction} {FileName}: {State:l}: {Basis:l}", root.GetProperty("MessageTemplate").GetString());
        Assert.Contains("failed: machine-away: no answer", root.GetProperty("RenderedMessage").GetString(), StringComparison.Ordinal);
        var properties = root.GetProperty("Properties");
        Assert.Equal(
            (7, correction.FileName, "uploading", "vmc", "00-1-2-01"),
            (properties.GetProperty("Correction").GetInt32(), Text("FileName"), Text("From"), Text("Machine"), Text("Trace")));
        using var failure = JsonDocument.Parse(lines[1]);
        Assert.Contains("outer\nline", failure.RootElement.GetProperty("Exception").GetString(), StringComparison.Ordinal);

        string? Text(string name) => properties.GetProperty(name).GetString();
    }

    [Fact]
    public void For_people_each_entry_is_one_line_whatever_a_file_is_called()
    {
        using var text = new StringWriter();
        var message = new Serilog.Parsing.MessageTemplateParser().Parse("{FileName}: {Basis:l}");
        var properties = new[]
        {
            ("FileName", "a\n23:00:00 inf well\u001b[2J\u202E.csv"),
            ("Basis", "so \"it\" is")
        }.Select(p => new Serilog.Events.LogEventProperty(p.Item1, new Serilog.Events.ScalarValue(p.Item2)));
        new CellLogLines().Format(
            new(new DateTimeOffset(2026, 11, 21, 22, 5, 6, TimeSpan.Zero), Serilog.Events.LogEventLevel.Warning, null, message, properties),
            text);
        Assert.Equal("22:05:06 wrn a\\n23:00:00 inf well\\u001b[2J\\u202e.csv: so \"it\" is\n", text.ToString());
    }

    [Fact]
    public void It_rolls_by_size_and_keeps_as_many_files_as_it_shall()
    {
        const int Lines = 120;
        for (var day = 1; day <= 9; day++)
        {
            File.WriteAllText(_folder[string.Create(CultureInfo.InvariantCulture, $"cell-2020010{day}.jsonl")], "{}\n");
        }

        File.WriteAllText(_folder["running.json"], "{}");
        using (var log = CellLog.Open(_folder.Path, mostBytesOfFile: 4096, mostFiles: 5))
        {
            for (var i = 0; i < Lines; i++)
            {
                log.Debug("{Number} {Text}", i, new string('x', 200));
            }
        }

        Assert.True(File.Exists(_folder["running.json"]));
        var files = Files.Where(f => Path.GetFileName(f) != "running.json").ToArray();
        Assert.Equal(5, files.Length);
        Assert.All(files, f => Assert.Matches(Name(), Path.GetFileName(f)));

        // The line that goes beyond the size is the last of its file.
        Assert.All(files, f => Assert.InRange(new FileInfo(f).Length, 1, 4096 + 1024));
        var numbers = files.SelectMany(File.ReadAllLines).Select(NumberOf).ToArray();
        Assert.Equal(Enumerable.Range(Lines - numbers.Length, numbers.Length), numbers);
        Assert.InRange(numbers.Length, 5, Lines - 1);
    }

    [Fact]
    public void A_file_is_named_after_its_day()
    {
        var before = TimeProvider.System.GetLocalNow();
        using (var log = CellLog.Open(_folder.Path))
        {
            log.Debug("one line");
        }

        var name = Path.GetFileName(Assert.Single(Files));
        Assert.Contains(
            name,
            new[]
            {
                before,
                TimeProvider.System.GetLocalNow()
            }.Select(t => t.ToString("'cell-'yyyyMMdd'.jsonl'", CultureInfo.InvariantCulture)));
    }

    [Fact]
    public void The_page_for_who_installs_it_says_how_much_is_kept()
    {
        var page = File.ReadAllText(Repository.PathTo("docs", "install-a-cell.md"));
        Assert.Contains(
            string.Create(CultureInfo.InvariantCulture, $"at most {CellLog.MostFiles} files of {CellLog.MostBytesOfFile >> 20} MB"),
            page,
            StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Dispose();

    private static int NumberOf(string line)
    {
        using var document = JsonDocument.Parse(line);
        return document.RootElement.GetProperty("Properties").GetProperty("Number").GetInt32();
    }

    [GeneratedRegex(@"\Acell-[0-9]{8}(_[0-9]{3})?\.jsonl\z", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Name();
}
