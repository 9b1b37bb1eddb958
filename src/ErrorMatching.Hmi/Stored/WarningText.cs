using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Texts for the warnings of a report.</summary>
internal static class WarningText
{
    /// <summary>The warning in the display language if the station knows its code; otherwise the report's sentence.</summary>
    public static string Of(ReportWarning warning)
    {
        ArgumentNullException.ThrowIfNull(warning);
        var texts = Texts.Current;
        return texts.Or("Warning." + warning.Code, "").Length > 0
            ? texts.With("Warning." + warning.Code, [.. warning.Values])
            : warning.Message;
    }
}
