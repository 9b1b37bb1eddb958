using System.Collections.ObjectModel;

namespace ErrorMatching.Hmi;

/// <summary>Rows that are shown anew as a whole; those that are the same stay, with what is chosen and focused in them.</summary>
/// <typeparam name="T">A row: a record, equal to another one that shows the same.</typeparam>
public sealed class RowList<T> : ObservableCollection<T>
{
    /// <summary>Shows other rows.</summary>
    public void Show(IReadOnlyList<T> rows)
    {
        ArgumentNullException.ThrowIfNull(rows);
        for (var i = 0; i < rows.Count; i++)
        {
            if (i == Count)
            {
                Add(rows[i]);
            }
            else if (!EqualityComparer<T>.Default.Equals(this[i], rows[i]))
            {
                this[i] = rows[i];
            }
        }

        while (Count > rows.Count)
        {
            RemoveAt(Count - 1);
        }
    }
}
