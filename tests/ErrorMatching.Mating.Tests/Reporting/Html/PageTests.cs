using System.Globalization;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

public sealed class PageTests
{
    private const string Hostile = "<script>alert('1')</script>\"><img src=x onerror=\"alert(1)\">&amp;\u0000\u202E\uD800]]>";

    private static readonly Lazy<MatchReport> Complex = new(() =>
    {
        var job = Samples.Job("complex-mating");
        MatchInput input = new(
            job,
            File("theoretical.csv"),
            File("part.csv"),
            null,
            "counterpart.nc",
            System.IO.File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc")));
        return MatchReporter.Report(Matcher.Match(input).Result!, "out/counterpart.nc", 0.01);

        static MeasurementFile File(string name) =>
            MeasurementReader.Read(Repository.PathTo("samples", "complex-mating", name), MeasurementFormat.Points);
    });

    public static TheoryData<string> Pages => ["match", "sample", "bare", "hostile", "verify", "hostile-verify"];

    [Theory]
    [MemberData(nameof(Pages))]
    public void Page_is_well_formed(string page)
    {
        var root = PageReader.Read(Write(page));

        Assert.Equal("html", root.Name);
        Assert.Equal("en", (string?)root.Attribute("lang"));
    }

    [Theory]
    [MemberData(nameof(Pages))]
    public void Page_fetches_nothing_and_runs_nothing(string page)
    {
        var root = PageReader.Read(Write(page));

        Assert.DoesNotContain(
            root.Descendants(),
            e => e.Name.LocalName is "script"
                or "link"
                or "img"
                or "iframe"
                or "object"
                or "embed"
                or "use"
                or "image"
                or "form"
                or "base");
        Assert.DoesNotContain(
            root.Descendants().Attributes(),
            a => a.Name.LocalName is "src" or "srcset" or "style" || a.Name.LocalName.StartsWith("on", StringComparison.OrdinalIgnoreCase));
        Assert.All(root.Descendants().Attributes("href"), a => Assert.StartsWith("#", a.Value, StringComparison.Ordinal));
        Assert.DoesNotContain("://", root.Value, StringComparison.Ordinal);
        Assert.DoesNotContain("@import", root.Descendants("style").Single().Value, StringComparison.Ordinal);
        Assert.All(
            Regex.Matches(root.ToString(), @"url\(.", RegexOptions.NonBacktracking, TimeSpan.FromSeconds(5)),
            m => Assert.Equal("url(#", m.Value));
        Assert.Contains(
            "default-src 'none'",
            root.Descendants("meta")
                .Select(m => (string?)m.Attribute("content"))
                .Single(c => c?.Contains("src", StringComparison.Ordinal) == true));
    }

    [Theory]
    [MemberData(nameof(Pages))]
    public void Every_table_has_a_caption_heads_and_full_rows_and_can_be_scrolled_by_keyboard(string page)
    {
        var tables = PageReader.Read(Write(page)).Descendants("table").ToArray();

        Assert.NotEmpty(tables);
        Assert.All(tables, table =>
        {
            Assert.NotEmpty(table.Element("caption")!.Value);
            var top = table.Element("thead")!.Elements("tr").First().Elements().ToArray();
            Assert.All(
                table.Element("thead")!.Descendants("tr").Elements(), h => Assert.Matches("^col(group)?$", (string?)h.Attribute("scope")));
            var columns = top.Sum(h => (int?)h.Attribute("colspan") ?? 1);
            Assert.All(table.Element("tbody")!.Elements("tr"), row =>
            {
                Assert.Equal(columns, row.Elements().Count());
                Assert.Equal("row", (string?)Assert.Single(row.Elements("th")).Attribute("scope"));
            });
            var region = table.Parent!;
            Assert.Equal("region|0", $"{(string?)region.Attribute("role")}|{(string?)region.Attribute("tabindex")}");
            Assert.Equal((string?)table.Element("caption")!.Attribute("id"), (string?)region.Attribute("aria-labelledby"));
        });
    }

    [Theory]
    [MemberData(nameof(Pages))]
    public void Every_reference_within_the_page_has_one_target(string page)
    {
        var root = PageReader.Read(Write(page));
        var ids = root.Descendants().Attributes("id").Select(a => a.Value).ToArray();
        string[] references =
        [
            .. root.Descendants().Attributes("href").Select(a => a.Value[1..]),
            .. root.Descendants().Attributes("aria-labelledby").SelectMany(a => a.Value.Split(' ')),
            .. root.Descendants()
                .Attributes("fill")
                .Where(a => a.Value.StartsWith("url(#", StringComparison.Ordinal))
                .Select(a => a.Value[5..^1]),
        ];

        Assert.Equal(ids.Distinct(), ids);
        Assert.Empty(references.Except(ids));
    }

    [Theory]
    [MemberData(nameof(Pages))]
    public void Every_drawing_has_a_title_a_description_and_a_caption(string page)
    {
        var root = PageReader.Read(Write(page));

        // The plot, the assembly before and after, and the sample's pair at its seat.
        Assert.Equal(page == "sample" ? 4 : 3, root.Descendants("svg").Count());
        Assert.All(root.Descendants("svg"), svg =>
        {
            Assert.Equal("img", (string?)svg.Attribute("role"));
            Assert.NotEmpty(svg.Element("title")!.Value);
            Assert.NotEmpty(svg.Element("desc")!.Value);
            Assert.NotEmpty(svg.Ancestors("figure").Single().Element("figcaption")!.Value);
        });
    }

    [Theory]
    [MemberData(nameof(Pages))]
    public void The_same_report_makes_the_same_bytes_under_any_culture(string page)
    {
        var (before, expected) = (CultureInfo.CurrentCulture, Write(page));
        var comma = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        comma.NumberFormat.NumberDecimalSeparator = ",";
        comma.NumberFormat.NegativeSign = "~";
        try
        {
            CultureInfo.CurrentCulture = comma;
            Assert.Equal(expected, Write(page));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }

        Assert.DoesNotContain((byte)'\r', expected);
        Assert.Equal((byte)'<', expected[0]);
    }

    [Fact]
    public void Hostile_text_stays_text()
    {
        var root = PageReader.Read(Write("hostile"));
        const string shown = "<script>alert('1')</script>\"><img src=x onerror=\"alert(1)\">&amp;\uFFFD[U+202E]\uFFFD]]>";

        Assert.Contains(shown, root.Descendants("h1").Single().Value, StringComparison.Ordinal);
        Assert.Contains(shown, root.ById("summary").Descendants("li").Select(l => l.Value));
        Assert.Equal(["x" + shown, "x" + shown], root.Table("blocks-table").Descendants("code").Select(c => c.Value));
        Assert.Contains(root.Table("key-points-table").Descendants("th"), h => h.Value == shown);
    }

    private static byte[] Write(string page) => page switch
    {
        "match" => MatchReportHtml.Write(HandMadeReport.Report),
        "sample" => MatchReportHtml.Write(Complex.Value),
        "bare" => MatchReportHtml.Write(Bare),
        "hostile" => MatchReportHtml.Write(HostileReport),
        "verify" => VerifyReportHtml.Write(HandMadeReport.Verified),
        _ => VerifyReportHtml.Write(HandMadeReport.Verified with
        {
            Job = HostileReport.Job,
            Result = HandMadeReport.Verified.Result with
            {
                Points = [.. HandMadeReport.Verified.Result.Points.Select(p => p with { Label = Hostile })]
            },
            Warnings = [Hostile],
        }),
    };

    /// <summary>Without anything that a report may lack.</summary>
    private static MatchReport Bare => HandMadeReport.Report with
    {
        Job = HandMadeReport.Report.Job with { WorkOrder = null },
        Inputs = [],
        Alignments = [],
        OriginCheck = null,
        Chain = null,
        RadiusWearMm = null,
        Warnings = [],
        Notes = [],
        Program = new("counterpart.nc", "", 0, 0, []),
        Proof = new(true, 12, 0, [], null, 0, true),
        KeyPoints = [.. HandMadeReport.Report.KeyPoints.Select(p => p with { Blocks = [] })],
    };

    private static MatchReport HostileReport => HandMadeReport.Report with
    {
        Job = new(Hostile, Hostile, Hostile, Hostile),
        Inputs = [new("part", Hostile, Hostile)],
        Features = [HandMadeReport.Line with { Name = Hostile, Quantities = [new(new(Hostile, 1, 2, 3), null)] }],
        KeyPoints = [
            .. HandMadeReport.Report.KeyPoints.Take(2).Select(
                (p, i) => p with { Point = Hostile + (i == 0 ? "" : "2"), Feature = Hostile, Blocks = [Hostile] })],
        Program = new(Hostile, Hostile, 1, 1, [new(Hostile, 1, "x" + Hostile, "x" + Hostile, [new(1, 4)], [new(1, 4)])]),
        Proof = new(true, 1, 1, [new(Hostile, 1, NeighborRole.Fillet, 0)], Hostile, 0, true),
        Warnings = [new(Hostile, Hostile, Hostile)],
        Notes = [Hostile],
    };
}
