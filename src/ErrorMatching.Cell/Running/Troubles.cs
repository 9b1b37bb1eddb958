using System.Collections.Concurrent;

namespace ErrorMatching.Cell;

/// <summary>What keeps the workers of a running cell from working just now.</summary>
internal sealed class Troubles(TimeProvider clock)
{
    private readonly ConcurrentDictionary<string, CellTrouble> _open = new(StringComparer.Ordinal);

    /// <summary>All of them by the name of the worker.</summary>
    public IReadOnlyList<CellTrouble> Open => [.. _open.Values.OrderBy(t => t.Where, StringComparer.Ordinal)];

    /// <summary>A worker is kept from working.</summary>
    /// <returns>True if it was not before, or by something else.</returns>
    public bool Begin(string where, string code, string message)
    {
        var isNew = true;
        _open.AddOrUpdate(where, _ => new(where, code, message, clock.GetUtcNow()), (_, old) =>
        {
            isNew = old.Code != code;
            return old with { Code = code, Message = message };
        });
        return isNew;
    }

    /// <summary>A worker works again.</summary>
    /// <returns>True if it did not before.</returns>
    public bool End(string where) => !_open.IsEmpty && _open.TryRemove(where, out _);
}
