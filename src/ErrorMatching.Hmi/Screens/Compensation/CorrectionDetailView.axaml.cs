using System.ComponentModel;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>All details of one correction.</summary>
internal sealed partial class CorrectionDetailView : UserControl
{
    // Below this height, notes about the rows scroll.
    private const double LowHeight = 480;

    private object? _begun;

    public CorrectionDetailView()
    {
        InitializeComponent();

        // The last tab gets its data context last; opening a tab earlier would show the previous content.
        CourseSide.DataContextChanged += (_, _) =>
        {
            OpenWhatIsThere();
            if (CourseSide.DataContext is CorrectionDetail { IsAtWarnings: true, HasWarnings: true })
            {
                ShowWarnings();
            }
        };
        ProgramList.Loaded += (_, _) => BeginAtFirstChange();
        ProgramTexts.SizeChanged += (_, _) => LayPath();
        Sides.SelectionChanged += (_, e) => ShowPathIfOpened(e.Source);
        ProgramSide.DataContextChanged += (_, _) => ShowPathIfOpened(Sides);
        ProgramList.PropertyChanged += (_, e) =>
        {
            if (e.Property == ItemsControl.ItemsSourceProperty)
            {
                Dispatcher.UIThread.Post(BeginAtFirstChange, DispatcherPriority.Loaded);
            }
        };
    }

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnSizeChanged(e);
        Classes.Set("low", e.NewSize.Height < LowHeight);
    }

    private ProgramLines? Lines => (DataContext as CorrectionDetail)?.Lines;

    // A tab that this correction lacks cannot stay open.
    private void OpenWhatIsThere()
    {
        if (CourseSide.DataContext is CorrectionDetail detail && !Has(detail, Sides.SelectedItem))
        {
            Sides.SelectedItem = detail.IsSurface ? SurfaceSide : Sides.Items[detail.HasReport ? 0 : Sides.ItemCount - 1];
        }
    }

    private bool Has(CorrectionDetail detail, object? side) =>
        side == SurfaceSide
            ? detail.IsSurface
            : side == ProgramSide
            ? detail.Lines is not null
            : side == CourseSide
            ? detail.HasCourse
            : side == CounterpartSide
            ? detail.HasCounterparts
            : side == DecisionsSide || detail.HasReport;

    private void OnFindUp(object? sender, RoutedEventArgs e) => Find(-1);

    private void OnFindDown(object? sender, RoutedEventArgs e) => Find(1);

    private void OnSoughtKey(object? sender, KeyEventArgs e)
    {
        if (e.Key == Key.Enter)
        {
            Find(1);
            e.Handled = true;
        }
    }

    private void Find(int step)
    {
        var found = Lines?.Find(Sought.Text ?? "", At(), step);
        NotFound.IsVisible = found is null && !string.IsNullOrWhiteSpace(Sought.Text);
        Show(found);
    }

    private void ShowPathIfOpened(object? source)
    {
        if (source == Sides)
        {
            _ = ShowPathAsync().Watched();
        }
    }

    // The path is read when somebody looks at the program, and only then.
    private async Task ShowPathAsync()
    {
        if (DataContext is not CorrectionDetail detail || Sides.SelectedItem != ProgramSide)
        {
            return;
        }

        var picture = await detail.PictureAsync();
        if (DataContext != detail)
        {
            return;
        }

        if (ProgramPath.Picture is { } old)
        {
            old.PropertyChanged -= OnPath;
        }

        picture?.PropertyChanged += OnPath;
        ProgramPath.Picture = picture;
        PathMessage.Text = picture?.Message;
        LayPath();
    }

    // Where the buttons of the path have no room, the rows have all of it.
    private void LayPath()
    {
        ProgramPath.IsVisible = ProgramPath.Picture is not null && ProgramTexts.Bounds.Height >= (double)this.FindResource("PlotLeast")!;
        PathMessage.IsVisible = ProgramPath.IsVisible && PathMessage.Text is not null;
        Grid.SetColumnSpan(ProgramTexts, ProgramPath.IsVisible ? 1 : 2);
    }

    // A line that is chosen lights its moves, and a move that is tapped its line.
    private void OnLine(object? sender, SelectionChangedEventArgs e)
    {
        if (ProgramPath.Picture is { } picture && At() is >= 0 and var line && picture.Selection != BlockRange.Between(line, line))
        {
            picture.Light(line);
        }
    }

    private void OnPath(object? sender, PropertyChangedEventArgs e)
    {
        if (sender is ProgramPicture { Selection: { } chosen } && chosen.First != At() && chosen.First < ProgramList.ItemCount)
        {
            Show(chosen.First);
        }
    }

    private void OnPrevious(object? sender, RoutedEventArgs e) =>
        Show(Lines?.Changes.Where(c => c < At()).Select(c => (int?)c).LastOrDefault());

    private void OnNext(object? sender, RoutedEventArgs e) =>
        Show(Lines?.Changes.Where(c => c > At()).Select(c => (int?)c).FirstOrDefault());

    private void ShowWarnings() => Sides.SelectedItem = DecisionsSide;

    private int At() => ProgramList.SelectedIndex;

    private void Show(int? line)
    {
        if (line is { } index)
        {
            ProgramList.SelectedIndex = index;
            ShowInTheMiddle(index);
        }
    }

    // The marker at the top fills a screen and does not concern the cut. A user who has scrolled stays in place, even after a
    // change of language.
    private void BeginAtFirstChange()
    {
        if (ProgramList is { IsLoaded: true, ItemsSource: ProgramLines lines } && lines != _begun)
        {
            _begun = lines;
            if (lines.Changes is [var first, ..])
            {
                ShowInTheMiddle(first);
            }
        }
    }

    // The lines before and after a change matter as much as the change.
    private void ShowInTheMiddle(int index)
    {
        ProgramList.ScrollIntoView(index);
        ProgramList.UpdateLayout();
        if (ProgramList.ContainerFromIndex(index) is { } row
            && ProgramList.Scroll is ScrollViewer scroll
            && row.TranslatePoint(new(0, row.Bounds.Height / 2), scroll) is { } middle)
        {
            scroll.Offset = scroll.Offset.WithY(Math.Max(0, scroll.Offset.Y + middle.Y - (scroll.Viewport.Height / 2)));
        }
    }
}
