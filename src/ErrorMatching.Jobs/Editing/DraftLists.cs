namespace ErrorMatching.Jobs;

/// <summary>Lists that are never changed, with one item changed.</summary>
public static class DraftLists
{
    /// <summary>The list with another item in a place.</summary>
    public static IReadOnlyList<T> Replaced<T>(this IReadOnlyList<T> list, int index, T item)
    {
        ArgumentNullException.ThrowIfNull(list);
        var copy = list.ToArray();
        copy[index] = item;
        return copy;
    }

    /// <summary>The list without the item in a place.</summary>
    public static IReadOnlyList<T> Without<T>(this IReadOnlyList<T> list, int index)
    {
        ArgumentNullException.ThrowIfNull(list);
        return [.. list.Take(index), .. list.Skip(index + 1)];
    }
}
