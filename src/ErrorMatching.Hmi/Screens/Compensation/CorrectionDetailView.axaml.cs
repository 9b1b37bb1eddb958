using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>One correction with all that is known of it.</summary>
public sealed partial class CorrectionDetailView : UserControl
{
    /// <summary>The view.</summary>
    public CorrectionDetailView() => InitializeComponent();

    private ProgramLines? Lines => (DataContext as CorrectionDetail)?.Lines;

    /// <inheritdoc/>
    protected override void OnDataContextChanged(EventArgs e)
    {
        base.OnDataContextChanged(e);

        // A side that this correction lacks cannot stay open.
        if (DataContext is CorrectionDetail detail && !Has(detail, Sides.SelectedItem))
        {
            Sides.SelectedItem = detail.IsSurface ? SurfaceSide : Sides.Items[detail.HasReport ? 0 : Sides.ItemCount - 1];
        }
    }

    private bool Has(CorrectionDetail detail, object? side) =>
        side == SurfaceSide ? detail.IsSurface : side == ProgramSide ? detail.Lines is not null : side == CourseSide || detail.HasReport;

    private void OnPrevious(object? sender, RoutedEventArgs e) => Show(Lines?.Changes.Where(c => c < At()).Select(c => (int?)c).LastOrDefault());

    private void OnNext(object? sender, RoutedEventArgs e) => Show(Lines?.Changes.Where(c => c > At()).Select(c => (int?)c).FirstOrDefault());

    private int At() => ProgramList.SelectedIndex;

    private void Show(int? line)
    {
        if (line is { } index)
        {
            ProgramList.SelectedIndex = index;
            ProgramList.ScrollIntoView(index);
        }
    }
}
