using System.Collections.ObjectModel;

namespace ErrorMatching.Hmi;

/// <summary>Rows that are shown anew as a whole; those that are the same stay, with what is chosen and focused in them.</summary>
/// <typeparam name="T">A row: a record, equal to another one that shows the same.</typeparam>
public sealed class RowList<T> : ObservableCollection<T>
{
    /// <summary>Shows other rows. Those before and behind what changed stay also where it is longer or shorter than it was.</summary>
    public void Show(IReadOnlyList<T> rows)
    {
        ArgumentNullException.ThrowIfNull(rows);
        var least = Math.Min(Count, rows.Count);
        var (first, same) = (0, EqualityComparer<T>.Default);
        while (first < least && same.Equals(this[first], rows[first]))
        {
            first++;
        }

        var behind = 0;
        while (behind < least - first && same.Equals(this[^(behind + 1)], rows[^(behind + 1)]))
        {
            behind++;
        }

        if (first < Math.Max(Count, rows.Count))
        {
            RowsChange.Tell();
        }

        for (var i = first; i < rows.Count - behind; i++)
        {
            if (i == Count - behind)
            {
                Insert(i, rows[i]);
            }
            else if (!same.Equals(this[i], rows[i]))
            {
                this[i] = rows[i];
            }
        }

        while (Count > rows.Count)
        {
            RemoveAt(rows.Count - behind);
        }
    }
}
