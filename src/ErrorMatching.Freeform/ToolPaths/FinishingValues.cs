using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The values of the placeholders of a <see cref="FinishingTemplate"/>.</summary>
internal sealed class FinishingValues(ToolPath path, FreeformJob job, CuttingStage stage, NcDialect dialect, string template)
{
    private readonly CommentText _comments = new(dialect);

    /// <summary>Names of the placeholders, except those of the tool.</summary>
    public static readonly string[] OfProgram =
        [
            "name", "order", "stage", "passes", "points", "minutes", "diameter", "flutes", "moves", "stock", "scallop", "chord", "rpm",
            "feed", "travel"];

    public string Feed { get; } = Word(job, "feedMmPerMin", job.Tool.FeedMmPerMin, 3);

    /// <summary>Fills the placeholders of lines.</summary>
    /// <exception cref="InputException">Speed or feed would be written as 0, or the tool has no such value.</exception>
    public byte[] Fill(IReadOnlyList<TemplateItem> items)
    {
        var text = new StringBuilder();
        TemplateText.Write(text, items, Holds, ValueOf, _comments.Line, _ => throw new InvalidOperationException("There are no points."));
        return Encoding.UTF8.GetBytes(text.ToString());
    }

    private bool Holds(string condition) => condition switch
    {
        TemplateGrammar.Order => !string.IsNullOrWhiteSpace(job.WorkOrder),
        TemplateGrammar.ToolByName => job.Toolpath.Tool?.Name is not null,
        _ => job.Toolpath.Tool is not null,
    };

    private string ValueOf(string place) => place switch
    {
        "name" => _comments.Of(job.Name),
        "order" => _comments.Of(job.WorkOrder ?? ""),
        "stage" => _comments.Of(FinishingProgram.NameOf(stage)),
        "passes" => Count(path.Passes),
        "points" => Count(path.Points),
        "minutes" => Number(path.LengthMm / job.Tool.FeedMmPerMin, 1),
        "diameter" => Number(2 * path.RadiusMm, 4),
        "flutes" => Count(job.Tool.Flutes),
        "moves" => _comments.Of(job.Toolpath.ProgramsTip ? "tip" : "center"),
        "stock" => Number(path.StockMm, 4),
        "scallop" => Number(path.Certificate.ScallopMm, 6),
        "chord" => Number(path.Certificate.ChordMm, 6),
        "rpm" => Word(job, "spindleRpm", job.Tool.SpindleRpm, 0),
        "feed" => Feed,
        "travel" => (path.TravelCenterZ - (job.Toolpath.ProgramsTip ? path.RadiusMm : 0))
            .ToString("F" + Count(path.Decimals), CultureInfo.InvariantCulture),
        _ => job.Toolpath.Tool!.ValueOf(place, template),
    };

    // A job cannot intend a stopped spindle or a feed of 0.
    private static string Word(FreeformJob job, string key, double value, int decimals) => Number(value, decimals) is var text and not "0"
        ? text
        : throw InputException.At(
            "rounds-to-zero",
            job.File,
            string.Create(
                CultureInfo.InvariantCulture,
                $"{key} of {value} would be written as 0; at least {Elementary.Pow(10, -decimals)} is expected"));

    private static string Number(double value, int decimals) =>
        Math.Round(value, decimals).ToString("0." + new string('#', decimals), CultureInfo.InvariantCulture);

    private static string Count(int value) => value.ToString(CultureInfo.InvariantCulture);
}
