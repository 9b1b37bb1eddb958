using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class RecognizerTests : IDisposable
{
    private const string Plan = "ERRORMATCH PROBE PLAN 0123456789ABCDEF MM\nP1 C X1. Y2. Z3.\n";
    private readonly CellFolder _cell = new();

    public void Dispose() => _cell.Dispose();

    [Fact]
    public void A_file_name_says_job_serial_number_and_work_order()
    {
        var found = Recognize("cmm", "WO-12_AB7.csv", "");
        Assert.Equal(("housing", "part", "AB7", "WO-12", null), (found.Job?.Name, found.Piece, found.Serial, found.WorkOrder, found.Code));
    }

    [Theory]
    [InlineData("C1-cp", "counterpart")]
    [InlineData("-part", "part")]
    public void The_rules_of_a_job_say_whose_measurement_it_is(string ending, string piece)
    {
        var found = Recognize("cmm", $"cover{ending}.csv", "point,x_mm,y_mm,serial\n1,0,0,C7\n2,1,0,C7\n");
        Assert.Equal(("cover", piece, "C7"), (found.Job?.Name, found.Piece, found.Serial));
    }

    [Fact]
    public void A_file_that_the_rules_of_its_job_do_not_decide_is_refused_with_their_code() =>
        Assert.Equal("undecided-source", Recognize("cmm", "cover.csv", "point,x_mm,y_mm,serial\n1,0,0,C7\n").Code);

    [Fact]
    public void A_counterpart_is_measured_for_feedback()
    {
        var found = Recognize("cmm", "fb_1.csv", "serial,point,x_mm,y_mm\n17,1,0,0\n");
        Assert.Equal(("feedback", "counterpart", "17"), (found.Job?.Name, found.Piece, found.Serial));
    }

    [Theory]
    [InlineData(Plan, "blade")]
    [InlineData("%\r\n; SERIAL: 4711\r\n" + Plan, "blade")]
    [InlineData("ERRORMATCH PROBE PLAN X MM\n", null)]
    [InlineData("", null)]
    public void The_plan_of_a_probing_log_says_its_job(string log, string? job) =>
        Assert.Equal(job, Recognize("probe", "PROBE.LOG", log).Job?.Name);

    [Fact]
    public void Comments_of_a_probing_log_say_what_the_shops_template_writes()
    {
        var settings = _cell.Read(CellFolder.With(
            "{ \"name\": \"PLAN\", \"pattern\": \"^[0-9A-F]{16}$\" }", "{ \"name\": \"serial\", \"pattern\": \"^(?<serial>[0-9]+)$\" }"));
        var found = new Recognizer(settings).Recognize("probe", "PROBE.LOG", Encoding.UTF8.GetBytes("; Serial = 4711\n" + Plan));
        Assert.Equal(("blade", "surface", "4711"), (found.Job?.Name, found.Piece, found.Serial));
    }

    [Theory]
    [InlineData("stranger.csv")]
    [InlineData("")]
    [InlineData("WO-1_a.csv")]
    [InlineData("WO-1_A.csv.exe")]
    [InlineData("../WO-1_A.csv")]
    [InlineData("WO-1_A\uFFFD.csv")]
    public void A_file_that_no_job_takes_is_refused_and_told_what_the_jobs_want(string name)
    {
        var found = Recognize("cmm", name, "");
        Assert.Equal(("unknown-piece", null), (found.Code, found.Job));
        Assert.Contains("asked-wants(housing, like-name(", Stated.As(found.Reason), StringComparison.Ordinal);
    }

    [Fact]
    public void A_gauge_that_no_job_listens_to_has_no_takers() =>
        Assert.Contains("no job listens", Recognize("else", "WO-1_A.csv", "").Reason!.Sentence, StringComparison.Ordinal);

    [Fact]
    public void A_file_that_several_jobs_take_is_refused_with_their_names()
    {
        var settings = _cell.Read(CellFolder.With(
            "{ \"fileName\": \"^fb_\", \"column\": { \"name\": \"serial\", \"pattern\": \"^(?<serial>[0-9]+)$\" } }",
            "{ \"fileName\": \"\" }".Replace("\"\"", "\"csv$\"", StringComparison.Ordinal)));
        var found = new Recognizer(settings).Recognize("cmm", "WO-12_AB7.csv", default);
        Assert.Equal("ambiguous-piece", found.Code);
        Assert.Contains("\"housing\", \"feedback\"", found.Reason!.Sentence, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("serial,point,x_mm,y_mm\n17,1,0,0\n18,2,0,0\n", "contradictory-piece")]
    [InlineData("serial,point,x_mm,y_mm\n17,1,0,0\nX,2,0,0\n", "unknown-piece")]
    [InlineData("serial,point,x_mm,y_mm\n17,1,NaN,0\n", "not-a-number")]
    [InlineData("point,x_mm,y_mm\n1,0,0\n", "unknown-piece")]
    [InlineData("", "empty-file")]
    [InlineData("PK\u0003\u0004", "binary-file")]
    [InlineData("serial,point,x_mm,y_mm\n17,1,0\n", "short-row")]
    public void A_file_that_must_be_looked_into_is_refused_with_the_code_of_what_is_wrong_in_it(string text, string code) =>
        Assert.Equal(code, Recognize("cmm", "fb_1.csv", text).Code);

    [Fact]
    public void A_file_whose_name_says_enough_is_not_looked_into() =>
        Assert.Equal("housing", Recognize("cmm", "WO-1_A.csv", "\0\0\0").Job?.Name);

    [Fact]
    public void A_serial_number_longer_than_anybody_marks_is_refused() =>
        Assert.Equal("contradictory-piece", Recognize("cmm", $"WO-1_{new string('A', 101)}.csv", "").Code);

    [Fact]
    public void A_job_whose_file_has_gone_since_is_named()
    {
        var recognizer = new Recognizer(_cell.Read(CellFolder.Right));
        File.Delete(_cell.PathOf("jobs/ruled.json"));
        var found = recognizer.Recognize("cmm", "cover-part.csv", Encoding.UTF8.GetBytes("point,x_mm,y_mm,serial\n1,0,0,C7\n"));
        Assert.Equal("unusable-job", found.Code);
        Assert.Contains("ruled.json", found.Reason!.Sentence, StringComparison.Ordinal);
    }

    private RecognitionResult Recognize(string gauge, string name, string text) =>
        new Recognizer(_cell.Read(CellFolder.Right)).Recognize(gauge, name, Encoding.UTF8.GetBytes(text));
}
