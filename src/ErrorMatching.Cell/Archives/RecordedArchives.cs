using System.Data.Common;
using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>The archives that the audit trail names.</summary>
internal static class RecordedArchives
{
    /// <summary>How many contents were moved to each archive, by its name.</summary>
    public static IReadOnlyDictionary<string, long> Of(DbConnection connection, DbTransaction? transaction)
    {
        var found = new Dictionary<string, long>(StringComparer.Ordinal);
        foreach (var entry in Rows.Query(
            connection, AuditRow.Select + $" WHERE what = '{RecordedThinning.Thinned}' ORDER BY seq", AuditRow.Read, null, transaction))
        {
            if (entry.Subject is { } subject && subject.Is(RecordedThinning.Archive) && entry.Basis.Is(RecordedThinning.Moved)
                && long.TryParse(entry.Basis.Values[0].Words, NumberStyles.None, CultureInfo.InvariantCulture, out var count)
                && subject.Values[0].Words is { } name)
            {
                found[name] = found.GetValueOrDefault(name) + count;
            }
        }

        return found;
    }
}
