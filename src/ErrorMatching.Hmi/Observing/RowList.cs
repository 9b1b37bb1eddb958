using System.Collections.ObjectModel;
using System.Collections.Specialized;

namespace ErrorMatching.Hmi;

/// <summary>Rows that are replaced as a whole. Equal rows stay, with their selection and focus.</summary>
/// <typeparam name="T">A row: a record that is equal to another one if both look the same.</typeparam>
public sealed class RowList<T> : ObservableCollection<T>
{
    // If more rows change, the list is laid out as a whole: a list box needs longer for so many single changes.
    private const int Most = 300;

    /// <summary>Shows other rows. Rows before and after the change stay, even if the number of rows changes.</summary>
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
            RowsChange.Report();
        }

        if (Math.Max(Count, rows.Count) - first - behind > Most)
        {
            Items.Clear();
            foreach (var row in rows)
            {
                Items.Add(row);
            }

            OnPropertyChanged(new(nameof(Count)));
            OnPropertyChanged(new("Item[]"));
            OnCollectionChanged(new(NotifyCollectionChangedAction.Reset));
            return;
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

/// <summary>Announces that rows on the screen are about to change, while all are still in place. Use it on the UI thread only.</summary>
internal static class RowsChange
{
    /// <summary>Raised before the rows of any list change.</summary>
    public static event Action? Coming;

    public static void Report() => Coming?.Invoke();
}
