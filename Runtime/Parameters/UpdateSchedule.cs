namespace Penumbra
{
    /// <summary>
    /// Which cascades are drawn anew in which frame, for render pipelines that draw their own cascades: a far cascade
    /// may be drawn less often, with a map that is older by what the sun and the casters have moved since. Each cascade
    /// keeps the matrices with which it was drawn. Phases are chosen so that no frame draws more cascades than it must:
    /// with periods 1, 2, 4 and 4 every frame draws two of four.
    /// <para>Periods are powers of two from 1 to 64, in frames; others are rounded down, and clamped. In the first
    /// frame and after a cut of the camera, draw all cascades, whatever is due. The error of old maps is in
    /// Documentation~/pipelines.md.</para>
    /// </summary>
    public readonly struct UpdateSchedule
    {
        public const int LongestPeriod = 64;

        public readonly int Cascades;
        private readonly CascadeCounts periods;
        private readonly CascadeCounts phases;

        /// <summary>One to four periods, of the nearest cascade first.</summary>
        public UpdateSchedule(params int[] periods)
        {
            Cascades = Bounded.Count(periods.Length, 0, AtlasLayout.MostCascades);
            this.periods = default;
            phases = default;
            for (var i = 0; i < Cascades; ++i) this.periods = this.periods.With(i, PowerOfTwo(periods[i]));
            // The shortest periods come first: a longer period always fits into a gap that shorter ones left.
            var load = new int[LongestPeriod];
            for (var period = 1; period <= LongestPeriod; period *= 2)
                for (var i = 0; i < Cascades; ++i)
                {
                    if (this.periods[i] != period) continue;
                    var phase = LeastLoaded(load, period);
                    phases = phases.With(i, phase);
                    for (var frame = phase; frame < LongestPeriod; frame += period) ++load[frame];
                }
        }

        /// <summary>
        /// Frames from one update of the cascade to the next; 1 for a cascade that the schedule lacks.
        /// </summary>
        public int Period(int cascade) => IsScheduled(cascade) ? periods[cascade] : 1;

        /// <summary>Frame of the first update, below the period.</summary>
        public int Phase(int cascade) => IsScheduled(cascade) ? phases[cascade] : 0;

        /// <summary>Frames since the last update; 0 when an update is due.</summary>
        public int Age(int cascade, int frame)
        {
            var period = Period(cascade);
            return ((frame - Phase(cascade)) % period + period) % period;
        }

        /// <summary>Whether the cascade is drawn in this frame.</summary>
        public bool IsDue(int cascade, int frame) => Age(cascade, frame) == 0;

        /// <summary>One bit for each cascade that is drawn in this frame, the lowest of cascade 0.</summary>
        public int Due(int frame)
        {
            var due = 0;
            for (var i = 0; i < Cascades; ++i)
                if (IsDue(i, frame)) due |= 1 << i;
            return due;
        }

        private bool IsScheduled(int cascade) => cascade >= 0 && cascade < Cascades;

        private static int PowerOfTwo(int period)
        {
            var power = 1;
            while (2 * power <= LongestPeriod && 2 * power <= period) power *= 2;
            return power;
        }

        // The phase at which the fewest of the cascades so far are due in any frame; the first of several.
        private static int LeastLoaded(int[] load, int period)
        {
            var best = 0;
            var fewest = int.MaxValue;
            for (var phase = 0; phase < period; ++phase)
            {
                var most = 0;
                for (var frame = phase; frame < LongestPeriod; frame += period)
                    if (load[frame] > most) most = load[frame];
                if (most >= fewest) continue;
                fewest = most;
                best = phase;
            }
            return best;
        }

        // The four numbers need no array, so that a schedule is copied as a value.
        private readonly struct CascadeCounts
        {
            private readonly int first;
            private readonly int second;
            private readonly int third;
            private readonly int fourth;

            private CascadeCounts(int first, int second, int third, int fourth)
            {
                this.first = first;
                this.second = second;
                this.third = third;
                this.fourth = fourth;
            }

            internal int this[int cascade] =>
                cascade == 0 ? first : cascade == 1 ? second : cascade == 2 ? third : fourth;

            internal CascadeCounts With(int cascade, int count) =>
                new CascadeCounts(cascade == 0 ? count : first, cascade == 1 ? count : second,
                                  cascade == 2 ? count : third, cascade == 3 ? count : fourth);
        }
    }
}
