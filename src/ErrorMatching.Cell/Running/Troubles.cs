using System.Collections.Concurrent;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>What currently prevents the workers of a running cell from working.</summary>
internal sealed class Troubles(TimeProvider clock)
{
    private readonly ConcurrentDictionary<string, CellTrouble> _open = new(StringComparer.Ordinal);

    /// <summary>All troubles, ordered by worker name.</summary>
    public IReadOnlyList<CellTrouble> Open => [.. _open.Values.OrderBy(t => t.Where, StringComparer.Ordinal)];

    /// <summary>Reports that a worker is prevented from working.</summary>
    /// <returns>True if this is new, or differs from its previous trouble.</returns>
    public bool Begin(string where, string code, Statement message)
    {
        var isNew = true;
        _open.AddOrUpdate(where, _ => new(where, code, message.Sentence, clock.GetUtcNow()) { Recorded = message.Text }, (_, old) =>
        {
            isNew = old.Code != code;
            return old with { Code = code, Message = message.Sentence, Recorded = message.Text };
        });
        return isNew;
    }

    /// <summary>Reports that a worker works again.</summary>
    /// <returns>True if it had a trouble.</returns>
    public bool End(string where) => !_open.IsEmpty && _open.TryRemove(where, out _);
}
