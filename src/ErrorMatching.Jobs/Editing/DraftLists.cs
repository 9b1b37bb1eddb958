namespace ErrorMatching.Jobs;

/// <summary>Copies of immutable lists with one item changed.</summary>
public static class DraftLists
{
    /// <summary>The list with one item replaced.</summary>
    public static IReadOnlyList<T> Replaced<T>(this IReadOnlyList<T> list, int index, T item)
    {
        ArgumentNullException.ThrowIfNull(list);
        var copy = list.ToArray();
        copy[index] = item;
        return copy;
    }

    /// <summary>The list with one item removed.</summary>
    public static IReadOnlyList<T> Without<T>(this IReadOnlyList<T> list, int index)
    {
        ArgumentNullException.ThrowIfNull(list);
        return [.. list.Take(index), .. list.Skip(index + 1)];
    }
}
