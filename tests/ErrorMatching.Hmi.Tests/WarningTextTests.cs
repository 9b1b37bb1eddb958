using System.Text;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi.Tests;

public sealed class WarningTextTests
{
    private const string Report = """
        {
          "warnings": ["C1 has 3 key points on 40 mm; one per 5 mm is recommended.", "Something that a later version says."],
          "warningCodes": [{ "code": "sparse-points", "values": ["C1", "3", "40", "5"] }, { "code": "not-known-here", "values": [] }]
        }
        """;

    [Fact]
    public Task A_warning_is_said_in_the_language_of_the_screen_and_one_that_is_not_known_as_it_came() => Seat.AtAsync(_ =>
    {
        var warnings = ReportReader.Document(Encoding.UTF8.GetBytes(Report)).Warnings();
        Assert.Equal(warnings.Select(w => w.Message.Replace(" mm", "\u00a0mm", StringComparison.Ordinal)), warnings.Select(WarningText.Of));
        Texts.Current.Language = Language.TraditionalChinese;
        Assert.Equal(
            ["C1 在 40\u00a0mm 上有 3 個關鍵點；建議每 5\u00a0mm 一點。", "Something that a later version says."],
            warnings.Select(WarningText.Of));
    });

    [Fact]
    public void Reports_from_before_warnings_had_codes_are_read() =>
        Assert.Equal(
            ["As it was said."],
            ReportReader.Document("""{ "warnings": ["As it was said."] }"""u8).Warnings().Select(WarningText.Of));

    [Fact]
    public void Every_problem_of_a_program_has_its_words()
    {
        string[] codes = ["unknown-code", "unknown-word", "bad-arc", "repeated-word", "corner-word", "tap-plane", "zero-scale"];
        Assert.All(codes, c => Assert.True(Texts.Of(Language.English).ContainsKey("Warning.nc-" + c), c));
    }
}
