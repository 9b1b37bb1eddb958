using System.Reflection;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Draws pages of reports from the reports themselves, so that a store need not keep both.</summary>
internal static class ReportPages
{
    /// <summary>The version of the program that draws here.</summary>
    public static string Version { get; } = typeof(ReportPages).Assembly
        .GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion.Split('+')[0];

    /// <summary>The page of a report.</summary>
    /// <returns>Null if the report alone does not determine its page, or cannot be read.</returns>
    public static byte[]? Of(ReadOnlyMemory<byte> report)
    {
        try
        {
            var document = ReportReader.Document(report.Span);
            return document.Schema switch
            {
                MatchReportJson.Schema => MatchReportHtml.Write(MatchReportJson.Read(document)),
                VerifyReportJson.Schema => VerifyReportHtml.Write(VerifyReportJson.Read(document)),
                _ => null,
            };
        }
        catch (InputException)
        {
            return null;
        }
    }
}
